package rsal.cli.terminal;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

class FileNameTest {
    @ParameterizedTest
    @CsvSource(textBlock = """
            C:\\labs\\my.yaml:fast,   \\,  C:/labs/my.yaml:fast
            ..\\labs,                  \\,  ../labs
            ../labs\\my.yaml,          \\,  ../labs/my.yaml
            odd\\name.yaml,            /,   odd\\name.yaml
            """)
    void onlyWindowsHasAnotherSeparator(String typed, char separator, String name) {
        assertThat(FileName.convert(typed, separator)).isEqualTo(name);
    }
}
