/// Runs the benchmarks of kernels, which are in the packages of what they measure.
package rsal.jmh;
