import type { MapInfo } from './messages';

const HEADER_BYTES = 16;

/** A map that a robot has drawn, as `DrawnMap` tells. */
export function decodeDrawn(
  buffer: ArrayBuffer,
  name: string,
  resolution: number,
): { map: MapInfo; bytes: Uint8Array } {
  const header = new DataView(buffer, 0, HEADER_BYTES);
  return {
    map: {
      name,
      width: header.getInt32(0, true),
      height: header.getInt32(4, true),
      resolution,
      originX: header.getInt32(8, true) / 1000,
      originY: header.getInt32(12, true) / 1000,
      colors: [],
    },
    bytes: new Uint8Array(buffer, HEADER_BYTES),
  };
}
