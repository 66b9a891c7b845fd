import type { MapInfo } from './messages';

const HEADER_BYTES = 32;

/** A grid of a robot's own: a map that it has drawn, or what places cost it. */
export interface Grid {
  map: MapInfo;
  bytes: Uint8Array;
}

/** @param buffer as `DrawnMap` tells */
export function decodeGrid(buffer: ArrayBuffer, name: string): Grid {
  const header = new DataView(buffer, 0, HEADER_BYTES);
  return {
    map: {
      name,
      width: header.getInt32(0, true),
      height: header.getInt32(4, true),
      resolution: header.getFloat64(8, true),
      originX: header.getFloat64(16, true),
      originY: header.getFloat64(24, true),
      colors: [],
      wallHeight: null,
    },
    bytes: new Uint8Array(buffer, HEADER_BYTES),
  };
}
