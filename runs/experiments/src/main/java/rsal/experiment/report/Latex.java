package rsal.experiment.report;

import java.util.HashMap;
import java.util.Map;
import java.util.stream.Collectors;

/// Text in the source of a paper.
final class Latex {
    private static final Map<Integer, String> WRITTEN = written();

    private Latex() {}

    private static Map<Integer, String> written() {
        var written = new HashMap<Integer, String>();
        "&%$#_{}".chars().forEach(sign -> written.put(sign, "\\" + (char) sign));
        written.put((int) '\\', "\\textbackslash{}");
        written.put((int) '~', "\\textasciitilde{}");
        written.put((int) '^', "\\textasciicircum{}");
        written.put((int) '<', "$<$");
        written.put((int) '>', "$>$");
        written.put((int) '−', "$-$");
        written.put((int) '±', "$\\pm$");
        written.put((int) '→', "$\\rightarrow$");
        written.put((int) '…', "\\dots{}");
        written.put((int) '–', "--");
        return written;
    }

    /// Plain text, in which no character does anything.
    static String text(String plain) {
        return plain.codePoints()
                .mapToObj(sign -> WRITTEN.getOrDefault(sign, Character.toString(sign)))
                .collect(Collectors.joining());
    }
}
