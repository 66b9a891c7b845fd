/// Tables in files of SQLite, read row by row, without SQL and without native code (sqlite.org/fileformat2.html).
@NullMarked
package rsal.ros2.sqlite;

import org.jspecify.annotations.NullMarked;
