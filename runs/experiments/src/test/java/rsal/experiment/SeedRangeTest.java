package rsal.experiment;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatIllegalArgumentException;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

class SeedRangeTest {
    @Test
    void bothEndsAreAmongThem() {
        assertThat(SeedRange.parse("7-9").seeds()).containsExactly(7L, 8L, 9L);
        assertThat(SeedRange.parse("-2--1").seeds()).containsExactly(-2L, -1L);
        assertThat(SeedRange.parse("7:9")).isEqualTo(new SeedRange(7, 9));
        assertThat(SeedRange.parse("-2:-1")).isEqualTo(new SeedRange(-2, -1));
    }

    @Test
    void aNumberAloneIsHowManyThereAre() {
        assertThat(SeedRange.parse("3")).isEqualTo(new SeedRange(1, 3));
        assertThat(SeedRange.parse(" 1 ")).isEqualTo(new SeedRange(1, 1));
    }

    @ParameterizedTest
    @CsvSource(quoteCharacter = '`', delimiter = '|', textBlock = """
            0                                          | '0' is less than one seed
            -5                                         | '-5' is less than one seed
            many                                       | 'many' is not a whole number, like 42. Maybe 20 seeds were meant (20)
            1..5                                       | or those from 101 to 120 (101:120)
            1000001                                    | at most 1000000
            5-4                                        | must go up
            1-x                                        | 'x' is not a whole number
            1:2:3                                      | '2:3' is not a whole number
            1-1000001                                  | at most 1000000
            -9223372036854775808-9223372036854775807   | at most 1000000
            """)
    void saysWhatIsWrong(String typed, String reported) {
        assertThatIllegalArgumentException()
                .isThrownBy(() -> SeedRange.parse(typed))
                .withMessageContaining(reported);
    }
}
