package rsal.cli.terminal;

import java.io.File;
import picocli.CommandLine.ITypeConverter;

/// Reads names of files and folders, so that the rest of the program meets one separator only: on Windows
/// `..\labs\hunt.yaml` becomes `../labs/hunt.yaml`, which Windows takes as well.
public final class FileName implements ITypeConverter<String> {
    @Override
    public String convert(String typed) {
        return convert(typed, File.separatorChar);
    }

    static String convert(String typed, char separator) {
        return typed.replace(separator, '/');
    }
}
