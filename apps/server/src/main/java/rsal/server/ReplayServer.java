package rsal.server;

import java.io.IOException;
import java.net.URI;
import java.nio.channels.ServerSocketChannel;
import java.nio.file.Path;
import java.util.Optional;
import rsal.recording.Playback;
import rsal.server.history.RecordedPast;
import rsal.server.http.AccessControl;
import rsal.server.http.Page;
import rsal.server.http.PageServer;
import rsal.server.live.Live;
import rsal.server.live.RecordingViewSource;

/// Shows a recording as [RunServer] shows a run, to be looked at alone: whatever would change a run is refused.
///
/// All methods may be called from any thread.
public final class ReplayServer implements AutoCloseable {
    private final Playback playback;
    private final PageServer server;

    /// Opens the port.
    ///
    /// @param playback whose this is from now on
    /// @param name of the recording, for people
    /// @param port 0 for any that is free
    /// @param token as [RunServer.Options] has it
    /// @param page directory of the built page
    /// @throws PortInUse when the port is taken
    /// @throws IOException when the page was not built, or the port can't be opened for another reason
    public static ReplayServer start(Playback playback, String name, int port, String token, Path page)
            throws IOException, PortInUse {
        var assets = new Page(page);
        ServerSocketChannel door = PortInUse.open(port);
        try {
            return new ReplayServer(playback, name, door, token, assets);
        } catch (RuntimeException e) {
            door.close();
            throw e;
        }
    }

    private ReplayServer(Playback playback, String name, ServerSocketChannel door, String token, Page page)
            throws IOException {
        this.playback = playback;
        var past = new RecordedPast(playback, name);
        var gate = new AccessControl(PageServer.port(door), token);
        var live = new Live(new RecordingViewSource(past), gate);
        server = new PageServer(
                door, token, gate, live, new ReplayApi(playback, past.run(), gate, page)::configure, Optional.empty());
    }

    /// The page's address, with the token in the part that browsers keep to themselves.
    public URI url() {
        return server.url();
    }

    /// Ends the server within a second, and closes the recording. Closing twice does nothing.
    @Override
    public void close() throws IOException {
        server.close();
        playback.close();
    }
}
