/// Small agents, devices and hosts for scenarios in tests to name.
@NullMarked
package rsal.testkit.example;

import org.jspecify.annotations.NullMarked;
