// Opens the line to the run while the rest of the page is still being loaded; src/live/connection.ts goes on with it.
{
  const socket = new WebSocket(new URL('api/live', location.href.replace(/^http/, 'ws')));
  socket.binaryType = 'arraybuffer';
  const early = { socket, said: [], closed: null };
  socket.onmessage = ({ data }) => early.said.push(data);
  socket.onclose = ({ code }) => (early.closed = code);
  globalThis.rsalEarly = early;
}
