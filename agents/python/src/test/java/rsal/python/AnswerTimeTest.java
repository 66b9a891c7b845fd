package rsal.python;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.time.Duration;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.condition.DisabledOnOs;
import org.junit.jupiter.api.condition.OS;

@Timeout(60)
@DisabledOnOs(OS.WINDOWS)
class AnswerTimeTest {
    private static Process process(String command) throws IOException {
        return new ProcessBuilder("sh", "-c", command).start();
    }

    @Test
    void whoReadsFromAProcessThatHangsGoesOn() throws IOException {
        Process process = process("sleep 100; echo late"); // the shell's child has its pipe, too
        try (var time = AnswerTime.of(process, Duration.ofMillis(200))) {
            assertThat(process.getInputStream().read()).isEqualTo(-1);
            assertThat(time.isOver()).isTrue();
        }
    }

    @Test
    void aProcessThatAnswersIsLeftAlone() throws IOException, InterruptedException {
        Process process = process("echo soon; read line; echo $line");
        AnswerTime answered;
        try (var time = AnswerTime.of(process, Duration.ofSeconds(2))) {
            assertThat(process.getInputStream().readNBytes(5)).asString().isEqualTo("soon\n");
            answered = time;
        }
        Thread.sleep(2100);
        assertThat(answered.isOver()).isFalse();
        process.getOutputStream().write("later\n".getBytes(StandardCharsets.UTF_8));
        process.getOutputStream().flush();
        assertThat(process.getInputStream().readAllBytes()).asString().isEqualTo("later\n");
    }
}
