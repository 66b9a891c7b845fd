package rsal.ros2.sqlite;

import java.util.ArrayList;
import java.util.List;
import java.util.Locale;

/// A table of a file.
///
/// @param root its first page
/// @param columns their names, in small letters
public record SqliteTable(String name, long root, List<String> columns) {
    private static final String QUOTES = "\"'`[";

    public SqliteTable {
        columns = List.copyOf(columns);
    }

    /// @param sql how it was made: `CREATE TABLE topics(id INTEGER PRIMARY KEY, name TEXT NOT NULL, …)`
    static SqliteTable of(String name, long root, String sql) {
        return new SqliteTable(name, root, columns(sql));
    }

    /// The number of a column, from 0; −1 where there is none, of which rows have no value.
    public int column(String column) {
        return columns.indexOf(column);
    }

    /// The first word of each part between commas. Constraints of the table stand behind all columns, so they do not
    /// change their numbers.
    private static List<String> columns(String sql) {
        var names = new ArrayList<String>();
        int depth = 0;
        int start = -1; // of the part
        for (int i = 0; i < sql.length(); i++) {
            char c = sql.charAt(i);
            if (QUOTES.indexOf(c) >= 0) {
                int end = sql.indexOf(c == '[' ? ']' : c, i + 1);
                i = end < 0 ? sql.length() - 1 : end;
            } else if (c == '(') {
                start = depth == 0 ? i + 1 : start;
                depth++;
            } else if (c == ')' || c == ',') {
                if (depth == 1 && start >= 0) {
                    names.add(firstWord(sql.substring(start, i).strip()));
                    start = i + 1;
                }
                depth -= c == ')' ? 1 : 0;
            }
        }
        return names;
    }

    private static String firstWord(String part) {
        if (!part.isEmpty() && QUOTES.indexOf(part.charAt(0)) >= 0) {
            int end = part.indexOf(part.charAt(0) == '[' ? ']' : part.charAt(0), 1);
            return part.substring(1, Math.max(1, end)).toLowerCase(Locale.ROOT);
        }
        return part.split("\\s", 2)[0].toLowerCase(Locale.ROOT);
    }
}
