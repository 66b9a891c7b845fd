package rsal.scenario.fault;

/// Patterns of names, in which a `*` stands for any letters or none.
public final class Wildcard {
    private Wildcard() {}

    public static boolean isPattern(String text) {
        return text.indexOf('*') >= 0;
    }

    /// Takes each star for as little as can be; only the last one may have to take more.
    public static boolean matches(String pattern, String name) {
        int at = 0;
        int star = -1; // the last that was met
        int after = 0; // where what follows it begins in the name
        int i = 0;
        while (i < name.length()) {
            if (at < pattern.length() && pattern.charAt(at) == '*') {
                star = at++;
                after = i;
            } else if (at < pattern.length() && pattern.charAt(at) == name.charAt(i)) {
                at++;
                i++;
            } else if (star >= 0) {
                at = star + 1;
                i = ++after;
            } else {
                return false;
            }
        }
        while (at < pattern.length() && pattern.charAt(at) == '*') {
            at++;
        }
        return at == pattern.length();
    }
}
