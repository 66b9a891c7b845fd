/// What programs on a multi-agent system without RSAL owe to benchmarks, which compare RSAL's agent hosts with them.
module rsal.bare {
    requires transitive rsal.data;
    requires static org.jspecify;

    exports rsal.bare;
}
