package rsal.navigation.carmen;

import java.io.IOException;
import java.io.InputStream;
import java.util.Optional;
import rsal.navigation.log.LaserHints;
import rsal.navigation.log.LogCollector;
import rsal.navigation.log.LogFormat;
import rsal.navigation.log.LogWriter;

/// CARMEN's logs, as [CarmenReader] reads them. Public logs end in `.log`, `.clf`, `.txt` and more, so all files are
/// taken for such logs that no other format reads.
public final class CarmenFormat implements LogFormat {
    @Override
    public String suffix() {
        return "";
    }

    @Override
    public String description() {
        return "CARMEN's logs: FLASER, ROBOTLASER1, and RAWLASER1 with ODOM.";
    }

    @Override
    public Optional<LogWriter> writer() {
        return Optional.of(new CarmenWriter());
    }

    @Override
    public void read(String file, InputStream in, LaserHints hints, LogCollector log) throws IOException {
        CarmenReader.read(file, in, hints, log);
    }
}
