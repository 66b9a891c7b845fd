package rsal.jason;

/// A file has a directive that is not read here.
final class InvalidDirective extends RuntimeException {
    private static final long serialVersionUID = 1;

    InvalidDirective(String message) {
        super(message);
    }
}
