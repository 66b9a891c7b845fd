package rsal.cli;

import static org.assertj.core.api.Assertions.assertThat;

import java.net.URL;
import org.junit.jupiter.api.Test;
import rsal.agent.AgentHostProvider;
import rsal.scenario.installed.Providers;

/// What comes with the command line.
class AssemblyTest {
    /// Jadex is under GPL-3.0, which would bind whoever passes RSAL on.
    @Test
    void jadexComesOnlyWhenItIsAskedFor() {
        var hosts = Providers.byKey(AgentHostProvider.class, AgentHostProvider::key);
        URL itself = getClass().getResource("/jadex/bridge/IExternalAccess.class");

        assertThat(hosts).containsKeys("jade", "jason", "plain");
        if (System.getProperty("rsal.with", "").equals("jadex")) { // -Pjadex
            assertThat(hosts).containsKey("jadex");
            assertThat(itself).isNotNull();
        } else {
            assertThat(hosts).doesNotContainKey("jadex");
            assertThat(itself).isNull();
        }
    }
}
