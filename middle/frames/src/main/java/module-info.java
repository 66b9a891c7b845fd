/// Frames of words and arrays between two processes, over pipes. Knows nothing of robots.
module rsal.frames {
    requires tools.jackson.databind;
    requires static org.jspecify;

    exports rsal.frame;
}
