/// What people set: parameters with their types, ranges and units, the values that were read, and where each of them
/// stands in its file. Knows no file format.
module rsal.settings {
    requires transitive rsal.data;
    requires static org.jspecify;

    exports rsal.settings;
}
