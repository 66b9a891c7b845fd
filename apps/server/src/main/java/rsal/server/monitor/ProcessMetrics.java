package rsal.server.monitor;

import com.sun.management.OperatingSystemMXBean;
import io.prometheus.metrics.model.snapshots.Labels;
import io.prometheus.metrics.model.snapshots.MetricSnapshot;
import io.prometheus.metrics.model.snapshots.SummarySnapshot;
import io.prometheus.metrics.model.snapshots.SummarySnapshot.SummaryDataPointSnapshot;
import java.lang.management.GarbageCollectorMXBean;
import java.lang.management.ManagementFactory;
import java.lang.management.MemoryUsage;
import java.util.List;
import java.util.stream.Stream;
import rsal.server.monitor.Family.Sample;

/// What this process takes of its machine, by the names that Prometheus's own libraries give it, so that dashboards
/// for Java know them.
final class ProcessMetrics {
    private ProcessMetrics() {}

    static Stream<MetricSnapshot> all() {
        var system = ManagementFactory.getPlatformMXBean(OperatingSystemMXBean.class);
        var memory = ManagementFactory.getMemoryMXBean();
        MemoryUsage heap = memory.getHeapMemoryUsage();
        return Stream.of(
                Family.counter(
                        "process_cpu_seconds_total",
                        "Processor time of this process, all cores together.",
                        Math.max(0, system.getProcessCpuTime()) / 1e9),
                Family.gauge(
                        "process_start_time_seconds",
                        "When this process began, since the epoch.",
                        ManagementFactory.getRuntimeMXBean().getStartTime() / 1e3),
                Family.gauge(
                        "jvm_memory_used_bytes",
                        "Memory in use.",
                        List.of(
                                Sample.of(heap.getUsed(), "area", "heap"),
                                Sample.of(memory.getNonHeapMemoryUsage().getUsed(), "area", "nonheap"))),
                Family.gauge(
                        "jvm_memory_max_bytes",
                        "Memory that may be used.",
                        List.of(Sample.of(heap.getMax(), "area", "heap"))),
                collections(ManagementFactory.getGarbageCollectorMXBeans()),
                Family.gauge(
                        "jvm_threads_current",
                        "Threads of this process.",
                        ManagementFactory.getThreadMXBean().getThreadCount()));
    }

    private static MetricSnapshot collections(List<GarbageCollectorMXBean> collectors) {
        var family = SummarySnapshot.builder()
                .name("jvm_gc_collection_seconds")
                .help("How long garbage was collected, and how often.");
        collectors.forEach(gc -> family.dataPoint(SummaryDataPointSnapshot.builder()
                .count(Math.max(0, gc.getCollectionCount()))
                .sum(Math.max(0, gc.getCollectionTime()) / 1e3)
                .labels(Labels.of("gc", gc.getName()))
                .build()));
        return family.build();
    }
}
