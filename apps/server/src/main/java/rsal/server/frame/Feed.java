package rsal.server.frame;

import java.util.List;
import rsal.engine.report.RunEvent;
import rsal.server.message.Messages.MotorsOff;

/// What viewers are shown of a run at one moment.
public interface Feed {
    /// Of the run, from 1.
    int number();

    /// The run's [rsal.server.message.Messages.RunInfo] as JSON.
    String info();

    /// How many robots the run has or had, in the order of frames. [#info] has them all.
    int robots();

    /// The [rsal.server.message.Messages.Newcomers] as JSON.
    ///
    /// @param known how many robots the viewer knows
    String newcomers(int known);

    /// What of the world is not a robot; the same until something comes or goes.
    ObjectRegistry things();

    /// Of the details, from 1; 0 while there are none.
    long detailsVersion();

    /// [rsal.server.message.Messages.Details] as JSON, as far as they are others than in a version that the
    /// viewer has.
    ///
    /// @param known that version; 0 for none
    String details(long known);

    /// As [FrameEncoder] writes it; not to be changed.
    byte[] frame();

    /// Of the frame, from 1 in each run; grows when the frame or the details are new.
    long sequence();

    /// Whose motors are off now; nobody's in a run that is over, or of the past, where nobody can arm them.
    default MotorsOff motorsOff() {
        return MotorsOff.NONE;
    }

    /// What has happened after an event, oldest first.
    ///
    /// @param sequence of that event; 0 for all
    List<RunEvent> events(long sequence);
}
