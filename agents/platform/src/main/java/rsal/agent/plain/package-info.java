/// The host for plain Java agents: no library, no thread of its own, every run repeatable.
@NullMarked
package rsal.agent.plain;

import org.jspecify.annotations.NullMarked;
