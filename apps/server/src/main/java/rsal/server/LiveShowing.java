package rsal.server;

/// Shows the run that goes on, and what has been of it. For one thread.
final class LiveShowing implements Showing {
    private final CurrentRun current;
    private RunFeed feed;
    private History history;

    LiveShowing(CurrentRun current) {
        this.current = current;
        feed = new RunFeed(current.now());
        history = new History(feed);
    }

    @Override
    public void look() {
        if (!feed.run().equals(current.now())) {
            feed = new RunFeed(current.now());
            history = new History(feed);
        }
        feed.look();
        history.keep(feed.time(), feed.isLast());
    }

    @Override
    public Feed live() {
        return feed;
    }

    @Override
    public Past past() {
        return history;
    }
}
