import embed, { type VisualizationSpec } from 'vega-embed';

/**
 * Draws the plots of a report: a page by itself, which carries this script and what to draw.
 * Each `figure` has its Vega-Lite specification in a `script` of its own.
 */
const dark = window.matchMedia('(prefers-color-scheme: dark)').matches;

for (const figure of document.querySelectorAll('figure')) {
  const specification = figure.querySelector('script')?.textContent;
  if (specification !== undefined) {
    const place = document.createElement('div');
    figure.append(place);
    void embed(place, JSON.parse(specification) as VisualizationSpec, {
      renderer: 'svg',
      actions: { export: true, source: false, compiled: false, editor: false },
      ...(dark ? { theme: 'dark' as const } : {}),
    });
  }
}
