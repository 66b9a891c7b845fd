package rsal.cli;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import picocli.CommandLine.Command;
import picocli.CommandLine.Option;
import picocli.CommandLine.Parameters;
import rsal.experiment.Findings;
import rsal.experiment.report.Report;

/// `rsal report`
@Command(
        name = "report",
        description = {
            "Write what came of a sweep to a page that can be sent to others: how runs ended, what was measured and how"
                    + " sure that is, and what each change does. Its figures are beside it as PNG and CSV.",
            "The sweep may still go on."
        })
final class ReportCommand extends Subcommand {
    @Parameters(paramLabel = "DIR", description = "The folder of a sweep ('rsal sweep … --out DIR').")
    private String sweep = "";

    @Option(
            names = "--out",
            paramLabel = "FILE.html",
            description = "Where to write the page; report.html in the sweep's folder when left out.")
    private Optional<String> out = Optional.empty();

    @Override
    int run() {
        Path folder = Destination.path(sweep);
        Findings findings = Findings.read(folder);
        Path page = out.map(Destination::path).orElse(folder.resolve("report.html"));
        check(
                page.toString().matches(".*\\.html?") && !Files.isDirectory(page),
                "--out must be a file like report.html, not (%s).".formatted(page));
        List<Path> written = write(findings, folder, page);
        if (json) {
            printJson(Map.of("files", written.stream().map(Path::toString).toList()));
        } else {
            out().println("%s, and its %d figures as PNG and CSV in %s"
                    .formatted(
                            page,
                            (written.size() - 1) / 2,
                            written.size() > 1 ? written.getLast().getParent() : page.getParent()));
            out().flush();
        }
        return Exit.SUCCESS;
    }

    private static List<Path> write(Findings findings, Path folder, Path page) {
        try {
            return Report.write(findings, folder, page);
        } catch (IOException e) {
            throw new Unreachable(
                    "The report can't be written to (%s): %s. Name a file in a folder that you may write to."
                            .formatted(page, e));
        }
    }
}
