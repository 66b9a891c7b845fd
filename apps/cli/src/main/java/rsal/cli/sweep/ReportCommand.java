package rsal.cli.sweep;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Map;
import java.util.Optional;
import picocli.CommandLine.Command;
import picocli.CommandLine.Option;
import picocli.CommandLine.ParameterException;
import picocli.CommandLine.Parameters;
import rsal.cli.terminal.Destination;
import rsal.cli.terminal.Exit;
import rsal.cli.terminal.FileName;
import rsal.cli.terminal.Subcommand;
import rsal.cli.terminal.Unreachable;
import rsal.experiment.Findings;
import rsal.experiment.report.Print;
import rsal.experiment.report.Report;
import rsal.experiment.report.Report.Written;

/// `rsal report`
@Command(
        name = "report",
        description = {
            "Write the results of a sweep to a page in one file: outcomes, metrics with confidence intervals,"
                    + " and the effect of each change. The command also writes figures (SVG, PDF, PNG, CSV) and"
                    + " tables (CSV, LaTeX).",
            "The sweep may still run."
        })
public final class ReportCommand extends Subcommand {
    @Parameters(
            converter = FileName.class,
            paramLabel = "DIR",
            description = "The folder of a sweep ('rsal sweep … --out DIR').")
    private String sweep = "";

    @Option(
            names = "--out",
            paramLabel = "FILE.html",
            description = "Where to write the page. Default: report.html in the sweep's folder.")
    private Optional<String> out = Optional.empty();

    @Option(
            names = "--figure-width",
            paramLabel = "MM",
            description = "Width of the figures for a paper (SVG, PDF). Default: 88 mm, one of two columns.")
    private double figureWidth = Print.COLUMN.millimeters();

    @Option(
            names = "--font",
            paramLabel = "NAME",
            description = "Font of the figures for a paper: one that is installed, or 'sans-serif', 'serif',"
                    + " 'monospace'. Default: 'sans-serif'.")
    private String font = Print.COLUMN.family();

    @Option(
            names = "--font-size",
            paramLabel = "PT",
            description = "Font size of the figures for a paper, in" + " points. Default: 8.")
    private double fontSize = Print.COLUMN.points();

    @Override
    protected int run() {
        Path folder = Destination.path(sweep);
        Findings findings = Findings.read(folder);
        Path page = out.map(Destination::path).orElse(folder.resolve("report.html"));
        check(
                page.toString().matches(".*\\.html?") && !Files.isDirectory(page),
                "--out must be a file like report.html, not '%s'.".formatted(page));
        Written written = write(findings, folder, page, print());
        if (json) {
            printJson(
                    Map.of("files", written.files().stream().map(Path::toString).toList()));
        } else {
            out().println(page);
            written.figures().ifPresent(figures -> out().println("Figures as SVG, PDF, PNG and CSV: " + figures));
            written.tables().ifPresent(tables -> out().println("Tables as CSV and LaTeX: " + tables));
            out().flush();
        }
        return Exit.SUCCESS;
    }

    private Print print() {
        try {
            return new Print(figureWidth, font, fontSize);
        } catch (IllegalArgumentException e) {
            throw new ParameterException(spec.commandLine(), String.valueOf(e.getMessage()), e);
        }
    }

    private static Written write(Findings findings, Path folder, Path page, Print print) {
        try {
            return Report.write(findings, folder, page, print);
        } catch (IOException e) {
            throw new Unreachable(
                    "The report can't be written to '%s': %s. Name a file in a folder that you may write to."
                            .formatted(page, e));
        }
    }
}
