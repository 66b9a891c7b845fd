package rsal.experiment.report;

/// How a report looks: light or dark as its reader likes it, always light on paper.
final class Style {
    private static final String SHEET = """
            :root { color-scheme: light dark; --page: #fff; --text: #1a1a1a; --quiet: #595959; --rule: #ddd;
              --data: #0072b2; --mean: #b34700; --link: #00578a; }
            @media (prefers-color-scheme: dark) { :root { --page: #16181c; --text: #e8e8e8; --quiet: #a9adb3;
              --rule: #3a3e45; --data: #56b4e9; --mean: #f0a050; --link: #7cc3ec; } }
            @media print { :root { color-scheme: light; --page: #fff; --text: #000; --quiet: #444; --rule: #bbb;
              --data: #0072b2; --mean: #b34700; } }
            body { margin: 0; background: var(--page); color: var(--text); font: 16px/1.55 system-ui, sans-serif; }
            main { max-width: 58rem; margin: 0 auto; padding: 2rem 1rem 4rem; }
            h1 { font-size: 1.75rem; line-height: 1.25; margin: 0 0 .5rem; }
            h2 { font-size: 1.2rem; margin: 0 0 .75rem; }
            h3 { font-size: 1rem; margin: 1.75rem 0 .5rem; }
            section { border-top: 1px solid var(--rule); margin-top: 2rem; padding-top: 1.5rem; }
            .kind, .note { color: var(--quiet); font-size: .9rem; }
            .kind { margin: 0 0 .25rem; }
            figure { margin: 0 0 1rem; overflow-x: auto; }
            svg { max-width: 100%; height: auto; font: 13px system-ui, sans-serif; }
            .wide { overflow-x: auto; }
            table { border-collapse: collapse; font-size: .875rem; font-variant-numeric: tabular-nums; width: 100%; }
            caption { text-align: left; color: var(--quiet); padding-bottom: .35rem; }
            th, td { text-align: right; padding: .3rem .6rem; border-bottom: 1px solid var(--rule); vertical-align: top; }
            th { font-weight: 600; } tbody th { font-weight: 400; }
            th:first-child { padding-left: 0; } th:last-child, td:last-child { padding-right: 0; }
            .words { text-align: left; }
            th:not(.words), td:not(.words) { white-space: nowrap; }
            pre { overflow-x: auto; background: color-mix(in srgb, var(--text) 6%, var(--page)); padding: .7rem .9rem;
              border-radius: 6px; font-size: .85rem; line-height: 1.4; }
            summary { cursor: pointer; overflow-wrap: anywhere; }
            .stroke { fill: none; stroke: currentColor; } .fill { fill: currentColor; }
            .box { stroke: currentColor; stroke-width: 1.2; fill: currentColor; fill-opacity: .16; }
            .text { color: var(--text); } .quiet { color: var(--quiet); } .grid { color: var(--rule); }
            .data { color: var(--data); } .mean { color: var(--mean); }
            .success { color: #35b08a; } .failure { color: #e2753a; } .timeout { color: #f0b840; }
            .limit { color: #7cc3ec; } .broken { color: #a6a6a6; } .on-bar { color: #1a1a1a; }
            .curve1 { color: var(--data); } .curve2 { color: #d55e00; } .curve3 { color: #009e73; }
            .curve4 { color: #cc79a7; } .curve5 { color: #b8860b; } .curve6 { color: #56b4e9; }
            @media print { main { max-width: none; padding: 0; } body { font-size: 11pt; }
              figure, tr, h2, h3 { break-inside: avoid; } h2, h3, caption { break-after: avoid; }
              .wide, pre { overflow: visible; } pre { white-space: pre-wrap; }
              svg { print-color-adjust: exact; -webkit-print-color-adjust: exact; } }
            """;

    private Style() {}

    /// Up to the beginning of the body.
    static String head(String title) {
        return """
                <!doctype html>
                <html lang="en">
                <head>
                <meta charset="utf-8">
                <meta name="viewport" content="width=device-width, initial-scale=1">
                <meta http-equiv="Content-Security-Policy" content="default-src 'none'; style-src 'unsafe-inline'">
                <title>%s: report of a sweep</title>
                <style>
                """.formatted(Html.text(title)) + SHEET + "</style>\n</head>\n<body>\n";
    }
}
