package rsal.settings;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import rsal.data.Rgb;

class ColorNamesTest {
    @ParameterizedTest
    @ValueSource(strings = {"DarkSlateGrey", "dark slate gray", "darkslategray"})
    void caseAndBlanksDoNotCount(String name) {
        assertThat(ColorNames.named(name)).contains(new Rgb(0x2f, 0x4f, 0x4f));
    }

    @Test
    void whatIsNoNameHasNoColor() {
        assertThat(ColorNames.named("#ff0000")).isEmpty();
        assertThat(ColorNames.named("")).isEmpty();
        assertThat(ColorNames.all()).contains("red", "gray30").doesNotContain("random");
    }
}
