/// What runs are judged by. A [rsal.metric.MetricType] offers quantities, which conditions and metrics of a
/// scenario can name, and signals, of which they can take means and percentiles. The engine hands it messages
/// and true poses.
@NullMarked
package rsal.metric;

import org.jspecify.annotations.NullMarked;
