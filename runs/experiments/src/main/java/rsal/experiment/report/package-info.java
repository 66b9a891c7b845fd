/// The report of an experiment: a page with its figures and tables.
@NullMarked
package rsal.experiment.report;

import org.jspecify.annotations.NullMarked;
