// Opens the line to the run while the rest of the page is still being loaded; src/live/connection.ts goes on with it, and
// opens later ones by the same function. The first picture waits for this file.
globalThis.rsalOpen = () => {
  // at the page's own address: each of the runs side by side has one
  const socket = new WebSocket(new URL('api/live', location.href.replace(/^http/, 'ws')));
  socket.binaryType = 'arraybuffer';
  const line = { socket, said: [], closed: null };
  socket.onmessage = ({ data }) => line.said.push(data);
  socket.onclose = ({ code }) => (line.closed = code);
  return line;
};
if (location.protocol === 'http:') {
  globalThis.rsalEarly = globalThis.rsalOpen();
} // else the server wants to see a token first: src/api/enter.ts
