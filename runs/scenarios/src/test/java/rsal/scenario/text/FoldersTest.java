package rsal.scenario.text;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

class FoldersTest {
    @ParameterizedTest
    @CsvSource(
            delimiter = '|',
            value = {
                "rsal run /home/bob/my/hunt.yaml:near --record /tmp/r.mcap | rsal run hunt.yaml:near --record r.mcap",
                "rsal sweep hunt.yaml --out=/home/bob/s --seeds=1-3 | rsal sweep hunt.yaml --out=s --seeds=1-3",
                "/home/bob/a.asl:3:4: There is no action 'gto'. | a.asl:3:4: There is no action 'gto'.",
                "It is looked for in '/home/bob/lab'. | It is looked for in 'lab'.",
                "rsal run lab/hunt.yaml --set speed=1/2 | rsal run lab/hunt.yaml --set speed=1/2",
                "0.5 m/s, 3 / 4, and/or | 0.5 m/s, 3 / 4, and/or",
                "http://127.0.0.1:8735/run | http://127.0.0.1:8735/run"
            })
    void namesOfFilesStayAndFoldersGo(String words, String without) {
        assertThat(Folders.without(words)).isEqualTo(without);
    }
}
