/**
 * Makes the Javadoc of what users program against, in docs/site/target/javadoc, where `prepare.mjs` takes it from:
 * `node javadoc.mjs JDK MODULE_PATH`. Comments write units in brackets, `[m/s]`, which Javadoc would take for links; so
 * it reads copies of the sources, with these brackets escaped.
 */
import { execFileSync } from 'node:child_process';
import { mkdirSync, readdirSync, readFileSync, rmSync, writeFileSync } from 'node:fs';
import { dirname, join } from 'node:path';
import { top } from './content.mjs';

const MODULES = [
  'middle/data',
  'middle/settings',
  'middle/devices',
  'middle/behaviors',
  'middle/models',
  'middle/worlds',
  'middle/navigation',
  'agents/api',
  'agents/platform',
  'agents/library',
];
const COMMENT = /^ *\/\/\/.*$/gm;
/** A link names a type, `[Pose2d]`, or a member, `[#x]`, or stands behind its text: `[its pose][Pose2d]`. */
const NO_LINK = /(?<!\])\[([a-zµ°%][^\]#[]*|[A-Z]|[A-Z]\/[^\]#[]*)\](?![[(])/g;

const [jdk, modulePath] = process.argv.slice(2);
const target = join(top, 'docs/site/target');
const sources = join(target, 'sources');

function copy(module) {
  const folder = join(top, module, 'src/main/java');
  const name = /^module (\S+)/m.exec(readFileSync(join(folder, 'module-info.java'), 'utf8'))[1];
  for (const file of readdirSync(folder, { recursive: true }).filter((path) => path.endsWith('.java'))) {
    const text = readFileSync(join(folder, file), 'utf8');
    const place = join(sources, name, file);
    mkdirSync(dirname(place), { recursive: true });
    writeFileSync(
      place,
      text.replace(COMMENT, (line) => line.replace(NO_LINK, '\\[$1\\]')),
    );
  }
  return name;
}

rmSync(sources, { recursive: true, force: true });
rmSync(join(target, 'javadoc'), { recursive: true, force: true });
execFileSync(
  join(jdk, 'bin/javadoc'),
  [
    ...['-quiet', '-Xdoclint:none', '-notimestamp', '-Werror'],
    ...['-encoding', 'UTF-8', '-windowtitle', 'RSAL Java API', '-doctitle', 'RSAL Java API'],
    ...['--module-path', modulePath, '--module-source-path', sources],
    ...['--module', MODULES.map(copy).join(',')],
    ...['-d', join(target, 'javadoc')],
  ],
  { stdio: 'inherit' },
);
