package rsal.cli.show;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.Optional;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

class ScenarioReferenceTest {
    @ParameterizedTest
    @CsvSource(textBlock = """
            hunt-and-prey,            hunt-and-prey,      ,
            hunt-and-prey:advanced,   hunt-and-prey,      advanced
            labs/my.yaml:fast,        labs/my.yaml,       fast
            a:b/my.yaml,              a:b/my.yaml,        ,
            a:b/my.yaml:fast,         a:b/my.yaml,        fast
            C:/labs/my.yaml,          C:/labs/my.yaml,    ,
            C:/labs/my.yaml:fast,     C:/labs/my.yaml,    fast
            """)
    void aConfigurationStandsBehindTheLastColon(String typed, String file, String configuration) {
        assertThat(ScenarioReference.parse(typed))
                .isEqualTo(new ScenarioReference(file, Optional.ofNullable(configuration)));
    }
}
