/** How wide a plot in the table is, and how much of that is left free at its ends, for half a dot [px]. */
export const WIDTH = 100;
export const EDGE = 5;
