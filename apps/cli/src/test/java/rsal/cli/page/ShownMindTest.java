package rsal.cli.page;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.api.Test;
import tools.jackson.databind.JsonNode;
import tools.jackson.databind.json.JsonMapper;

class ShownMindTest {
    private static final JsonNode AGENT = JsonMapper.shared().readTree("""
            {"agent": "collector-1", "status": "RUNNING", "state": "goes to (1.0499999999999998, -2.4)", "mind": {
              "beliefs": [
                {"name": "me", "value": "(0.46695204089382697, -1.9999999999999996, -0.00001°)"},
                {"name": "error", "value": "2.220446049250313E-16"},
                {"name": "plan", "value": "v1.23456 of 10.25.12345"}],
              "goals": [
                {"name": "greet", "state": "REACHED", "urgency": "3", "plans": ["wave"], "steps": [], "failure": ""},
                {"name": "fetch", "state": "PURSUED", "urgency": "0.30000000000000004", "plans": ["drive"],
                 "steps": ["fetch: drive"], "failure": ""},
                {"name": "rest", "state": "NOT_WANTED", "urgency": "1", "plans": ["stand"], "steps": [], "failure": ""}]}}
            """);

    @Test
    void numbersAreAsShortAsPeopleReadThem() {
        assertThat(ShownMind.text("collector-1", AGENT))
                .startsWith("Does\n  goes to (1.05, -2.4)\n")
                .contains("  me      (0.467, -2, 0°)\n", "  error   2.22E-16\n", "  plan    v1.23456 of 10.25.12345\n");
    }

    @Test
    void goalsThatHaveEndedAreApartFromThoseThatAreWanted() {
        assertThat(ShownMind.text("collector-1", AGENT)).endsWith("""
                Wants
                  pursued   fetch (0.3)
                              does: fetch: drive
                              plans: drive
                Does not want now
                  reached      greet (3)
                                 plans: wave
                  not wanted   rest (1)
                                 plans: stand
                """);
    }
}
