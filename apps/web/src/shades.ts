/** OKLab lightness that is seen on light and dark floors alike. */
const DARKEST = 0.42;
const LIGHTEST = 0.78;
/** More shades of a color could hardly be told apart; they begin again. */
const MOST = 8;

/**
 * Gives robots of one color shades of it, so that each can be told from the others. The first keeps the color. Shades
 * differ in lightness and not in hue: the hue is the role's, and those who see few hues see lightness.
 */
export function withShades<T extends { color: string }>(robots: readonly T[]): T[] {
  const colors = new Set(robots.map(({ color }) => color));
  const shades = new Map([...colors].map((color) => [color, shadesOf(color)]));
  const seen = new Map<string, number>();
  return robots.map((robot) => {
    const before = seen.get(robot.color) ?? 0;
    seen.set(robot.color, before + 1);
    return { ...robot, color: shades.get(robot.color)![before % MOST]! };
  });
}

/** A color and others that differ from it and each other as much as they can, the most different first. */
function shadesOf(color: string): string[] {
  const [lightness, a, b] = toOklab(color);
  const taken = [lightness];
  const free = (candidate: number) => Math.min(...taken.map((other) => Math.abs(candidate - other)));
  while (taken.length < MOST) {
    let best = DARKEST;
    for (let candidate = DARKEST; candidate <= LIGHTEST; candidate += 0.01) {
      best = free(candidate) > free(best) ? candidate : best;
    }
    taken.push(best);
  }
  return [color, ...taken.slice(1).map((other) => toHex(other, a, b))];
}

/**
 * Red, green and blue, 0 to 255.
 *
 * @param color `#rrggbb`
 */
export function channelsOf(color: string): [red: number, green: number, blue: number] {
  const all = parseInt(color.slice(1), 16);
  return [all >> 16, (all >> 8) & 255, all & 255];
}

/** Björn Ottosson, A perceptual color space for image processing, 2020. */
export function toOklab(color: string): [lightness: number, a: number, b: number] {
  const [red, green, blue] = channelsOf(color).map((channel) => toLinear(channel / 255)) as [
    number,
    number,
    number,
  ];
  const l = Math.cbrt(0.4122214708 * red + 0.5363325363 * green + 0.0514459929 * blue);
  const m = Math.cbrt(0.2119034982 * red + 0.6806995451 * green + 0.1073969566 * blue);
  const s = Math.cbrt(0.0883024619 * red + 0.2817188376 * green + 0.6299787005 * blue);
  return [
    0.2104542553 * l + 0.793617785 * m - 0.0040720468 * s,
    1.9779984951 * l - 2.428592205 * m + 0.4505937099 * s,
    0.0259040371 * l + 0.7827717662 * m - 0.808675766 * s,
  ];
}

function toHex(lightness: number, a: number, b: number): string {
  const l = (lightness + 0.3963377774 * a + 0.2158037573 * b) ** 3;
  const m = (lightness - 0.1055613458 * a - 0.0638541728 * b) ** 3;
  const s = (lightness - 0.0894841775 * a - 1.291485548 * b) ** 3;
  const linear = [
    4.0767416621 * l - 3.3077115913 * m + 0.2309699292 * s,
    -1.2684380046 * l + 2.6097574011 * m - 0.3413193965 * s,
    -0.0041960863 * l - 0.7034186147 * m + 1.707614701 * s,
  ];
  return `#${linear.map((channel) => byte(fromLinear(channel)).toString(16).padStart(2, '0')).join('')}`;
}

function byte(channel: number): number {
  return Math.round(255 * Math.min(1, Math.max(0, channel)));
}

/** From and to sRGB's curve (IEC 61966-2-1). */
function toLinear(channel: number): number {
  return channel <= 0.04045 ? channel / 12.92 : ((channel + 0.055) / 1.055) ** 2.4;
}

function fromLinear(channel: number): number {
  return channel <= 0.0031308 ? 12.92 * channel : 1.055 * channel ** (1 / 2.4) - 0.055;
}
