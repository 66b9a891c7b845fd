package rsal.scenario.fault;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

class WildcardTest {
    @ParameterizedTest
    @CsvSource({
        "hunter, hunter, true",
        "hunter, hunter-1, false",
        "hunter*, hunter, true",
        "hunter*, hunter-12, true",
        "*-1, hunter-1, true",
        "*-1, hunter-12, false",
        "h*-*1, hunter-11, true",
        "h*x*, hunter, false",
        "*, anything, true",
        "h*r, hr, true",
        "h*r, h, false",
        "h*h, h, false",
        "h**r, hunter, true",
        "*aab, aaaab, true",
        "'', '', true",
        "*, '', true",
        "'', h, false"
    })
    void aStarStandsForAnyLetters(String pattern, String name, boolean matches) {
        assertThat(Wildcard.matches(pattern, name)).isEqualTo(matches);
    }

    @Test
    @Timeout(value = 20, threadMode = Timeout.ThreadMode.SEPARATE_THREAD)
    void manyStarsAndALongNameAreNoMatterOfYears() {
        assertThat(Wildcard.matches("a*".repeat(20) + "b", "a".repeat(2000))).isFalse();
        assertThat(Wildcard.matches("a*".repeat(20) + "b", "a".repeat(2000) + "b"))
                .isTrue();
    }
}
