/// Runs the benchmarks of kernels, which are in the packages of what they measure, and has what slow ones share.
package rsal.jmh;
