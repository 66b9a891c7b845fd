package rsal.cli.terminal;

import picocli.CommandLine.IVersionProvider;

/// Which program this is: what recordings and sweeps keep, so that they can be made again.
public final class Build implements IVersionProvider {
    private static final String VERSION = "rsal 0.1.0";

    /// Its name and version, and the commit that it was built from, where the launcher knows that:
    /// `rsal 0.1.0 (1d2f3a4b5c6d)`, with `-dirty` when something was changed since.
    public static String name() {
        String commit = System.getProperty("rsal.commit", "");
        return commit.isEmpty() ? VERSION : "%s (%s)".formatted(VERSION, commit);
    }

    @Override
    public String[] getVersion() {
        return new String[] {name()};
    }
}
