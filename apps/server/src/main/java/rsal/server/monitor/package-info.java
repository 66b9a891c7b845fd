/// Metrics for Prometheus.
@NullMarked
package rsal.server.monitor;

import org.jspecify.annotations.NullMarked;
