import { existsSync, readdirSync, readFileSync } from 'node:fs';
import { dirname, join } from 'node:path';

/** The folder of the package that a module is of. */
function home(module) {
  for (let folder = dirname(module); folder.includes('node_modules'); folder = dirname(folder)) {
    const file = join(folder, 'package.json');
    if (existsSync(file) && JSON.parse(readFileSync(file, 'utf8')).version) {
      return folder;
    }
  }
}

function licence(folder) {
  const { name, version, license } = JSON.parse(readFileSync(join(folder, 'package.json'), 'utf8'));
  const file = readdirSync(folder).find((each) => /^licen[cs]e/i.test(each));
  return { name, version, identifier: license, text: file ? readFileSync(join(folder, file), 'utf8') : '' };
}

/** Writes licenses.json: which libraries the site has in it, with their licences, for releases. Vite 8 has that built in. */
export const licences = {
  name: 'licences',
  apply: 'build',
  generateBundle(_, bundle) {
    const modules = Object.values(bundle).flatMap((chunk) => Object.keys(chunk.modules ?? {}));
    const folders = new Set(
      modules
        .map((module) => module.replace(/^\0/, '').replace(/\?.*/, ''))
        .filter((module) => module.includes('node_modules'))
        .map(home)
        .filter(Boolean),
    );
    const source = JSON.stringify([...folders].sort().map(licence), null, 2);
    this.emitFile({ type: 'asset', fileName: 'licenses.json', source });
  },
};
