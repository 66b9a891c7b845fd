package rsal.bench.measurement;

import com.sun.management.OperatingSystemMXBean;
import com.sun.management.ThreadMXBean;
import java.lang.management.ManagementFactory;
import rsal.time.AllowedToReadWallClock;

/// What has passed since it was made: real time, time of all processors, bytes that this thread allocated.
@AllowedToReadWallClock("Benchmarks measure real time.")
public final class Stopwatch {
    private static final OperatingSystemMXBean SYSTEM =
            ManagementFactory.getPlatformMXBean(OperatingSystemMXBean.class);
    private static final ThreadMXBean THREADS = ManagementFactory.getPlatformMXBean(ThreadMXBean.class);

    private final long wall = System.nanoTime();
    private final long cpu = SYSTEM.getProcessCpuTime();
    private final long thread = THREADS.getCurrentThreadCpuTime();
    private final long bytes = THREADS.getCurrentThreadAllocatedBytes();

    /// [s]
    public double wall() {
        return (System.nanoTime() - wall) * 1e-9;
    }

    /// [s]; above [#wall] when several processors work
    public double cpu() {
        return (SYSTEM.getProcessCpuTime() - cpu) * 1e-9;
    }

    /// Of this thread alone [s].
    public double thread() {
        return (THREADS.getCurrentThreadCpuTime() - thread) * 1e-9;
    }

    public long bytes() {
        return THREADS.getCurrentThreadAllocatedBytes() - bytes;
    }

    /// Memory in use once everything is gone that nobody holds [MB].
    public static double memory() {
        return heap()
                + ManagementFactory.getMemoryMXBean().getNonHeapMemoryUsage().getUsed() * 1e-6;
    }

    /// The same of objects alone, without the program.
    public static double heap() {
        for (int i = 0; i < 3; i++) {
            System.gc();
        }
        return ManagementFactory.getMemoryMXBean().getHeapMemoryUsage().getUsed() * 1e-6;
    }
}
