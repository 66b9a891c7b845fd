import { spawn, type ChildProcess } from 'node:child_process';
import { once } from 'node:events';
import { fileURLToPath } from 'node:url';

/** The launcher, as people use it; RSAL names another command. */
const launcher = process.env.RSAL ?? fileURLToPath(new URL('../../../rsal', import.meta.url));

/**
 * RSAL without the JVM's second compiler: a run that lasts for seconds costs less with what the first one makes, by a third
 * of all that a test takes.
 */
const env = { ...process.env, JDK_JAVA_OPTIONS: '-XX:TieredStopAtLevel=1' };

/** A run with its page, in a process of its own. */
export class Rsal {
  private static readonly started = new Set<Rsal>();

  private constructor(
    private readonly process: ChildProcess,
    /** With the token. */
    readonly url: string,
    /** What was printed before the page's address. */
    readonly printed: string,
  ) {}

  static run(...options: string[]): Promise<Rsal> {
    return Rsal.start('run', ...options);
  }

  /** Lets people choose a scenario. */
  static serve(...options: string[]): Promise<Rsal> {
    return Rsal.start('serve', ...options);
  }

  /** Offers a scenario's robots to others; with `--page`, as it has an address then. */
  static bridge(protocol: string, ...options: string[]): Promise<Rsal> {
    return Rsal.start('bridge', protocol, ...options);
  }

  /** Shows a recording. */
  static replay(...options: string[]): Promise<Rsal> {
    return Rsal.start('replay', ...options);
  }

  /** Runs something without a page to its end. */
  static async headless(...options: string[]): Promise<void> {
    const child = spawn(launcher, options, { env, stdio: ['ignore', 'ignore', 'pipe'] });
    let output = '';
    child.stderr.on('data', (text: Buffer) => (output += text.toString()));
    const [code] = (await once(child, 'exit')) as [number];
    if (code !== 0) {
      throw new Error(`${launcher} ended with ${String(code)}:\n${output}`);
    }
  }

  private static async start(...options: string[]): Promise<Rsal> {
    const child = spawn(launcher, options, { env, stdio: ['ignore', 'pipe', 'pipe'] });
    let output = '';
    const url = await new Promise<string>((resolve, reject) => {
      const listen = (text: Buffer) => {
        output += text.toString();
        const found = /(http:\/\/127\.0\.0\.1:\d+\/#token=[\w&-]+)\s/.exec(output);
        if (found) {
          resolve(found[1]!);
        }
      };
      child.stdout.on('data', listen);
      child.stderr.on('data', listen);
      child.on('error', reject);
      child.on('exit', (code) => reject(new Error(`${launcher} ended with ${String(code)}:\n${output}`)));
    });
    const rsal = new Rsal(child, url, output);
    Rsal.started.add(rsal);
    return rsal;
  }

  /** Ends all that a test has left, however it went. */
  static async endAll(): Promise<void> {
    await Promise.all([...Rsal.started].map((rsal) => rsal.end()));
  }

  get origin(): string {
    return new URL(this.url).origin;
  }

  get port(): string {
    return new URL(this.url).port;
  }

  get token(): string {
    return new URLSearchParams(new URL(this.url).hash.slice(1)).get('token')!;
  }

  /** Commands the run as the page does. */
  post(command: string, body: object = {}): Promise<void> {
    return this.ask(`run/${command}`, body);
  }

  /** Begins a run beside those that are there. */
  beside(wish: object): Promise<void> {
    return this.ask('beside', wish);
  }

  /** Ends one of those. */
  close(run: number): Promise<void> {
    return this.ask(`beside/${run}`, {}, 'DELETE');
  }

  private async ask(what: string, body: object, method = 'POST'): Promise<void> {
    const response = await fetch(`${this.origin}/api/${what}`, {
      method,
      headers: { Authorization: `Bearer ${this.token}` },
      body: JSON.stringify(body),
    });
    if (!response.ok) {
      throw new Error(`${what}: ${await response.text()}`);
    }
  }

  async end(): Promise<void> {
    Rsal.started.delete(this);
    if (this.process.exitCode === null) {
      const ended = once(this.process, 'exit');
      this.process.kill('SIGINT');
      await ended;
    }
  }
}
