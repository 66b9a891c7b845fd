package rsal.settings;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.api.Test;

class OwnCodeTest {
    private static <T extends Throwable> T thrown(T failure, StackTraceElement... frames) {
        failure.setStackTrace(frames);
        return failure;
    }

    private static StackTraceElement frame(String loader, String file, int line) {
        return new StackTraceElement(loader, "", "", "AnyClass", "anyMethod", file, line);
    }

    @Test
    void failuresInFilesOfUsersNameFileAndLine() {
        var inside = thrown(
                new ArithmeticException("/ by zero"),
                frame("app", "Lists.java", 7),
                frame("plugins", "Cautious.java", 51),
                frame("plugins", "Cautious.java", 20));
        var failure = thrown(new IllegalStateException("wrapped", inside), frame("app", "Devices.java", 3));
        assertThat(OwnCode.words(failure)).isEqualTo("/ by zero (ArithmeticException in Cautious.java:51)");
        assertThat(OwnCode.hasFailed(failure)).isTrue();
    }

    @Test
    void otherFailuresAreTheirMessagesOrTypes() {
        var failure = thrown(new IllegalStateException("so it is"), frame("app", "Devices.java", 3));
        assertThat(OwnCode.words(failure)).isEqualTo("so it is");
        assertThat(OwnCode.words(thrown(new NullPointerException()))).isEqualTo("NullPointerException");
        assertThat(OwnCode.hasFailed(failure)).isFalse();
    }

    @Test
    void aPlaceHasTheFileFirst() {
        assertThat(OwnCode.place(new StackTraceElement("Hunter$Hunt", "hunt", "Hunter.java", 110)))
                .isEqualTo("Hunter.java:110 in Hunt.hunt");
        assertThat(OwnCode.place(new StackTraceElement("lab.Hunter", "hunt", null, -1)))
                .isEqualTo("Hunter.hunt");
    }
}
