import type { Layer } from '../scene';

/** Particles of the localizers, also on top of robots: close up, each shows its heading. */
export const drawParticles: Layer = (context, { info, frame, view, palette }) => {
  const size = Math.max(1.5, Math.min(3, 0.03 * view.scale)) / view.scale;
  const withHeadings = view.scale > 60;
  frame.robots.forEach(({ particles }, i) => {
    if (particles === null) {
      return;
    }
    const { originX, originY, unit, values } = particles;
    const dots = new Path2D();
    for (let at = 0; at < values.length; at += 4) {
      const x = originX + values[at]! * unit;
      const y = originY + values[at + 1]! * unit;
      dots.rect(x - size / 2, y - size / 2, size, size);
      if (withHeadings) {
        const heading = (values[at + 2]! / 0x10000) * 2 * Math.PI;
        dots.moveTo(x, y);
        dots.lineTo(x + 0.12 * Math.cos(heading), y + 0.12 * Math.sin(heading));
      }
    }
    context.globalAlpha = 0.5;
    context.fillStyle = info.robots[i]!.color;
    context.fill(dots);
    if (withHeadings) {
      context.strokeStyle = info.robots[i]!.color;
      context.lineWidth = 0.75 / view.scale;
      context.stroke(dots);
    }
    context.globalAlpha = 0.35;
    context.fillStyle = palette.text; // or they would not be seen on a body of their color
    context.fill(dots);
    context.globalAlpha = 1;
  });
};
