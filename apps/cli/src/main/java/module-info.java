/// The command `rsal`: reads what a person types, starts runs and the page, prints results. Knows nothing of how
/// robots, agents or algorithms work.
module rsal.cli {
    requires info.picocli;
    requires static org.jspecify;

    opens rsal.cli to
            info.picocli;
}
