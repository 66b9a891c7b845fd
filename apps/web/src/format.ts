/** Numbers as people read them. Degrees exist only here and where people type them. */

/** `1:02:03.4`, `2:03.4` */
export function clockTime(seconds: number): string {
  const tenths = Math.floor(seconds * 10 + 1e-6);
  const hours = Math.floor(tenths / 36000);
  const minutes = Math.floor(tenths / 600) % 60;
  const rest = ((tenths % 600) / 10).toFixed(1).padStart(4, '0');
  return hours > 0 ? `${hours}:${String(minutes).padStart(2, '0')}:${rest}` : `${minutes}:${rest}`;
}

/** `0.25×`, `12×`, `max` */
export function factor(value: number): string {
  if (!Number.isFinite(value)) {
    return 'max';
  }
  return `${value >= 10 ? Math.round(value) : Number(value.toPrecision(2))}×`;
}

/** -179° to 180° */
export function degrees(radians: number): string {
  const rounded = Math.round((radians * 180) / Math.PI);
  return `${rounded === -180 ? 180 : rounded}°`;
}

export function meters(value: number, digits = 2): string {
  return `${value.toFixed(digits)} m`;
}

export function seconds(value: number): string {
  return `${value.toFixed(1)} s`;
}

/**
 * A number of results, as everywhere else (Java's `NumberText`): whole numbers, counts above all, keep all their
 * digits; others are rounded to three, but for their whole part.
 */
export function numberText(value: number): string {
  const size = Math.abs(value);
  if (!Number.isFinite(value)) {
    return String(value);
  }
  if (size < GREATEST && Number.isInteger(size)) {
    return String(value === 0 ? 0 : value);
  }
  if (size < LEAST_PLAIN || size >= GREATEST) {
    return value.toExponential(DIGITS - 1).replace('e+', 'e');
  }
  const rounded = value.toPrecision(Math.max(DIGITS, String(Math.trunc(size)).length));
  return rounded.includes('e') ? String(Number(rounded)) : rounded;
}

const DIGITS = 3;
const LEAST_PLAIN = 1e-3;
const GREATEST = 1e15;

/** How long ago something was, as roughly as people want it: `12 s`, `5 min`, `3 h`. */
export function age(seconds: number): string {
  const [minutes, hours] = [Math.floor(seconds / 60), Math.floor(seconds / 3600)];
  return seconds < 120 ? `${Math.floor(seconds)} s` : minutes < 120 ? `${minutes} min` : `${hours} h`;
}

/** Words in which nothing is less than nothing: `-0°`, `-0.00` are what is left of a small number when it is rounded. */
export function unsigned(words: string): string {
  return words.includes('-0') ? words.replace(/(?<![\w.])-(?=0(?:\.0+)?(?![\d.]))/g, '') : words;
}

/** Nothing that agents reckon with is less: it is what is left of rounding. */
const LEAST = 1e-9;

/** Words with numbers as short as people read them: `0.46695204089382697` is `0.467`. */
export function brief(words: string): string {
  return unsigned(
    words.replace(/(?<![\w.])-?\d+\.(?:\d{4,}(?:[eE][-+]?\d+)?|\d+[eE][-+]?\d+)(?!\w|\.\d)/g, (number) =>
      shortened(Number(number)),
    ),
  );
}

/** To a thousandth, or three digits where that is less. */
function shortened(value: number): string {
  const size = Math.abs(value);
  return size < LEAST ? '0' : String(Number(size < 0.1 ? value.toPrecision(3) : value.toFixed(3)));
}
