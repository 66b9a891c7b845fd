/** What can be drawn on, whether it is seen or not. */
export type Context = CanvasRenderingContext2D | OffscreenCanvasRenderingContext2D;
