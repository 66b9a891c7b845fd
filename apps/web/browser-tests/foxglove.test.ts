import { FoxgloveClient, StatusLevel, type Channel, type MessageData } from '@foxglove/ws-protocol';
import protobuf from 'protobufjs';
import 'protobufjs/ext/descriptor/index.js';
import { afterEach, expect, it } from 'vitest';
import { WebSocket } from 'ws';
import { Rsal } from './rsal';

/* A run as Foxglove sees it: by Foxglove's own client, its messages read with nothing but what the run says of them. */

afterEach(() => Rsal.endAll());

/** What a client has been told. */
class Studio {
  readonly channels = new Map<string, Channel>();
  readonly messages = new Map<string, Record<string, unknown>>();
  readonly statuses: string[] = [];
  capabilities: string[] = [];
  times = 0;
  private readonly topics = new Map<number, Channel>();
  private readonly client: FoxgloveClient;

  constructor(url: string) {
    const socket = new WebSocket(url, [FoxgloveClient.SUPPORTED_SUBPROTOCOL]);
    this.client = new FoxgloveClient({
      ws: socket as unknown as ConstructorParameters<typeof FoxgloveClient>[0]['ws'],
    });
    this.client.on('serverInfo', (info) => (this.capabilities = info.capabilities));
    this.client.on('advertise', (channels) =>
      channels.forEach((channel) => {
        this.channels.set(channel.topic, channel);
        this.topics.set(this.client.subscribe(channel.id), channel);
      }),
    );
    this.client.on('message', (message) => this.take(message));
    this.client.on('time', () => this.times++);
    this.client.on('status', (status) =>
      this.statuses.push(`${StatusLevel[status.level]} ${status.message}`),
    );
  }

  private take({ subscriptionId, data }: MessageData) {
    const channel = this.topics.get(subscriptionId)!;
    this.messages.set(
      channel.topic,
      read(channel, new Uint8Array(data.buffer, data.byteOffset, data.byteLength)),
    );
  }

  publish(topic: string, message: object) {
    const channel = this.client.advertise({
      topic,
      encoding: 'json',
      schemaName: 'geometry_msgs/PoseStamped',
    });
    this.client.sendMessage(channel, new TextEncoder().encode(JSON.stringify(message)));
  }

  close() {
    this.client.close();
  }
}

const types = new Map<string, protobuf.Type>(); // by name, as to read a description takes longer than many messages

/** By the description that comes with the channel. */
function read(channel: Channel, data: Uint8Array): Record<string, unknown> {
  const descriptors = protobuf.Root as unknown as { fromDescriptor(set: Uint8Array): protobuf.Root };
  const type =
    types.get(channel.schemaName) ??
    descriptors.fromDescriptor(Buffer.from(channel.schema, 'base64')).lookupType(channel.schemaName);
  types.set(channel.schemaName, type);
  return type.toObject(type.decode(data), { longs: Number, defaults: true });
}

it("shows a run to Foxglove's own client, and takes goals from it", async () => {
  const rsal = await Rsal.run(
    'hunt-and-prey',
    '--seed',
    '7',
    '--port',
    '0',
    '--foxglove',
    '--foxglove-port',
    '0',
  );
  const url = /ws:\/\/localhost:\d+\/\?token=[\w-]+/.exec(rsal.printed)?.[0];
  expect(url).toBeDefined();
  const studio = new Studio(url!);
  try {
    for (const topic of ['/hunter-1/scan', '/tf', '/map']) {
      await expect.poll(() => studio.messages.has(topic), { timeout: 30_000, message: topic }).toBe(true);
    }
    expect(studio.capabilities).toEqual(expect.arrayContaining(['time', 'clientPublish']));
    await expect.poll(() => studio.times, { timeout: 30_000 }).toBeGreaterThan(5);

    expect(studio.channels.get('/hunter-1/scan')?.schemaName).toBe('foxglove.LaserScan');
    const scan = studio.messages.get('/hunter-1/scan') as {
      ranges: number[];
      start_angle: number;
      frame_id: string;
    };
    expect(scan.ranges.length).toBeGreaterThan(10);
    expect(scan.start_angle).toBeLessThan(0);
    const tf = studio.messages.get('/tf') as {
      transforms: { parent_frame_id: string; child_frame_id: string }[];
    };
    expect(tf.transforms).toContainEqual(
      expect.objectContaining({ parent_frame_id: 'map', child_frame_id: scan.frame_id }) as unknown,
    );
    const map = studio.messages.get('/map') as { column_count: number; data: Uint8Array };
    expect(map.data.length % map.column_count).toBe(0);
    expect(studio.channels.get('/world')?.schemaName).toBe('foxglove.SceneUpdate');

    const pose = { position: { x: 0, y: 0, z: 0 }, orientation: { x: 0, y: 0, z: 0, w: 1 } };
    studio.publish('/hunter-1/goal', { header: { frame_id: 'map' }, pose });
    await expect
      .poll(() => studio.statuses, { timeout: 30_000 })
      .toContainEqual(expect.stringContaining('hunter-1: goes to 0.00 0.00'));
    studio.publish('/hunter-1/goal', { header: { frame_id: 'odom' }, pose });
    await expect
      .poll(() => studio.statuses, { timeout: 30_000 })
      .toContainEqual(expect.stringMatching(/ERROR.*'map'/));

    // somebody at the page has control
    const page = new URL(rsal.url);
    const taken = await fetch(new URL('/api/control', page), {
      method: 'POST',
      headers: { authorization: `Bearer ${page.hash.slice('#token='.length)}`, 'rsal-operator': 'a' },
      body: JSON.stringify({ name: 'Anna', over: false }),
    });
    expect(taken.status).toBe(200);
    studio.publish('/hunter-1/goal', { header: { frame_id: 'map' }, pose });
    await expect
      .poll(() => studio.statuses, { timeout: 30_000 })
      .toContainEqual(expect.stringContaining('ERROR Anna has control of this run.'));
  } finally {
    studio.close();
  }
});
