package rsal.agent.protocol;

/// The side of one who was spoken to: says what the protocol allows, and learns when it is not wanted any more.
abstract class Answering implements Dialogue.Listener {
    private final Dialogue dialogue;
    private Runnable unwanted = () -> {};
    private boolean lost;

    Answering(Dialogue dialogue) {
        this.dialogue = dialogue;
    }

    public final String from() {
        return dialogue.partner();
    }

    public final void agree() {
        say(Performative.AGREE, "");
    }

    public final void refuse(String why) {
        say(Performative.REFUSE, why);
    }

    public final void fail(String why) {
        say(Performative.FAILURE, why);
    }

    public final void whenUnwanted(Runnable stop) {
        unwanted = stop;
        if (lost) {
            stop.run();
        }
    }

    final void say(Performative performative, Object content) {
        dialogue.say(performative, content);
    }

    @Override
    public void lost(String why) {
        lost = true;
        unwanted.run();
    }
}
