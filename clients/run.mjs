// Renders the exports in their engines, in a headless Chromium, and compares each pixel with the CPU evaluation; two
// exports of one engine with each other; and opens the check pages of the exports.
//
// Usage: node clients/run.mjs --pavo PAVO --packages DIR [--json] [NAME ...]
// DIR has node_modules; exports, points and screenshots go into it. Exit codes are those of the command pavo.

import { execFileSync } from 'node:child_process';
import { existsSync, mkdirSync, readFileSync, readdirSync, writeFileSync } from 'node:fs';
import { dirname, join, resolve } from 'node:path';
import { fileURLToPath } from 'node:url';
import { parseArgs } from 'node:util';
import { missing, onPage, serve } from './browser.mjs';

const here = dirname(fileURLToPath(import.meta.url));
const table = JSON.parse(readFileSync(join(here, 'clients.json'), 'utf8'));

function stop(code, message) {
    console.error(`error: ${message}`);
    process.exit(code);
}

const { values: given, positionals: names } = parseArgs({
    allowPositionals: true,
    options: { pavo: { type: 'string' }, packages: { type: 'string' }, json: { type: 'boolean', default: false } },
});
if (!given.pavo || !given.packages) stop(2, '--pavo and --packages are needed');
const packages = resolve(given.packages);
const known = table.clients.map((client) => client.name);
const unknown = names.filter((name) => !known.includes(name));
if (unknown.length > 0) stop(2, `${unknown.join(', ')}: no such client; the clients are ${known.join(', ')}`);
const clients = table.clients.filter((client) => names.length === 0 || names.includes(client.name));
const absent = missing(table.devices, packages);
if (absent) stop(3, `${absent}. Nothing was rendered`);
for (const folder of ['exports', 'points', 'screenshots']) mkdirSync(join(packages, folder), { recursive: true });
const server = await serve({ here, packages, imports: table.imports });

// The CPU evaluation of the scene at points, by the command.
function evaluated(points, name) {
    const header = 'cos_theta1,film_ior,thickness_nm,f0_r,f0_g,f0_b';
    const file = join(packages, 'points', `${name}.csv`);
    writeFileSync(file, `${header}\n${points.map((point) => point.join(',')).join('\n')}\n`);
    const text = execFileSync(given.pavo, ['eval', join(here, 'scene.toml'), '--points', file, '--on', 'cpu-f64'],
        { encoding: 'utf8', maxBuffer: 1 << 28, stdio: ['ignore', 'pipe', 'inherit'] });
    const rows = text.split('\n').filter((line) => line !== '' && !line.startsWith('#'));
    const columns = rows[0].split(',');
    const at = ['r', 'g', 'b'].map((name) => columns.indexOf(name));
    return rows.slice(1).map((row) => { const fields = row.split(','); return at.map((i) => Number(fields[i])); });
}

// The largest difference between colours, not a number where one is none.
function largest(found, expected) {
    let worst = 0;
    for (let i = 0; i < found.length; ++i) {
        for (let c = 0; c < 3; ++c) {
            const difference = Math.abs(found[i][c] - expected[i][c]);
            if (!(difference <= worst)) worst = difference;
        }
    }
    return worst;
}

// Outside of the sphere nothing is drawn; at the rim a cosine of 0 shows no film.
const isOnSphere = (term, i) => term[i + 3] > 0.01;

// Places of the pixels on the sphere in a term of four numbers a pixel.
function places(term) {
    const found = [];
    for (let i = 0; i < term.length; i += 4) if (isOnSphere(term, i)) found.push(i);
    if (found.length < table.size * table.size / 4) throw new Error(`the sphere has ${found.length} pixels only`);
    return found;
}

const exported = new Set();
function exports(engine) {
    const folder = join(packages, 'exports', engine);
    if (!exported.has(engine)) {
        execFileSync(given.pavo, ['export', join(here, 'scene.toml'), '--engine', engine, '-o', folder],
            { stdio: ['ignore', 'ignore', 'inherit'] });
        exported.add(engine);
    }
    return folder;
}

const results = [];
// Runs one row of the table; what goes wrong is its error.
async function row(client, device, messages, fill) {
    const result = { client, version: '', device: device.name, pixels: 0, max: Infinity, tolerance: device.tolerance, passed: false };
    results.push(result);
    try {
        Object.assign(result, await fill());
        result.passed = result.max <= result.tolerance;
    } catch (error) {
        result.error = error.message;
        console.error(`${client} on ${device.name}: ${error.message}\n${messages.slice(0, 20).join('\n')}`);
    }
}

// Renders a client's sphere with each of the settings; the terms that its material computes.
async function rendered(client, device, messages) {
    const name = `${client.name}-${device.name}`;
    const code = readFileSync(join(exports(client.engine), client.file), 'utf8');
    const webgpu = client.webgpu ?? false;
    return onPage({ device, webgpu, packages, address: server.address, size: table.size, messages }, async (tab, renderer) => {
        const version = await tab.evaluate(async ([module, code, size, webgpu]) => {
            window.client = await (await import(module)).open(code, size, webgpu);
            return String(window.client.version);
        }, [`/pages/${client.page}.js`, code, table.size, webgpu]);
        const terms = [];
        for (const settings of table.settings) {
            terms.push(await tab.evaluate(async (settings) => Array.from(await window.client.term(settings)), settings));
        }
        await tab.evaluate((settings) => window.client.show(settings), table.settings[1]);
        await tab.screenshot({ path: join(packages, 'screenshots', `${name}.png`) });
        return { version, renderer: `${webgpu ? 'WebGPU' : 'WebGL'}, ${renderer}`, terms };
    });
}

// How far the terms are from the CPU evaluation.
function compared(name, terms) {
    let max = 0;
    let pixels = 0;
    table.settings.forEach((settings, index) => {
        const term = terms[index];
        const on = places(term);
        const fixed = [Math.fround(settings.film_ior), settings.thickness_nm, ...settings.color.map(Math.fround)];
        const expected = evaluated(on.map((i) => [term[i + 3], ...fixed]), name);
        if (expected.length !== on.length) throw new Error('the evaluation has another number of points');
        const difference = largest(on.map((i) => term.slice(i, i + 3)), expected);
        if (!(difference <= max)) max = difference;
        pixels += on.length;
    });
    return { max, pixels };
}

const rendering = new Map();
for (const client of clients) {
    for (const device of table.devices) {
        const messages = [];
        const reason = client.not_on?.[device.name];
        if (reason) {
            console.error(`not run: ${client.name} on ${device.name}: ${reason}`);
            results.push({ client: client.name, device: device.name, not_run: reason });
            continue;
        }
        console.error(`rendering ${client.name} on ${device.name}`);
        await row(client.name, device, messages, async () => {
            const { terms, ...about } = await rendered(client, device, messages);
            rendering.set(`${client.name} ${device.name}`, terms);
            return { ...about, ...compared(`${client.name}-${device.name}`, terms) };
        });
    }
}

// Pixel by pixel; rows go up in both.
for (const { of: [first, second], tolerance } of table.pairs) {
    for (const device of table.devices) {
        const [a, b] = [first, second].map((name) => rendering.get(`${name} ${device.name}`));
        if (!names.length || (names.includes(first) && names.includes(second))) {
            await row(`${first} and ${second}`, device, [], async () => {
                if (!a || !b) throw new Error('one of the two was not rendered');
                let max = 0;
                let pixels = 0;
                a.forEach((term, index) => {
                    const on = places(term).filter((i) => isOnSphere(b[index], i));
                    if (on.length < 0.99 * places(term).length) throw new Error('the two spheres do not cover the same pixels');
                    const difference = largest(on.map((i) => term.slice(i, i + 3)), on.map((i) => b[index].slice(i, i + 3)));
                    if (!(difference <= max)) max = difference;
                    pixels += on.length;
                });
                return { max, pixels, tolerance };
            });
        }
    }
}

// The pages that the exports bring: what they say of themselves is read. On a device with inexact sines more is allowed
// than the page does.
for (const engine of new Set(clients.map((client) => client.engine))) {
    const folder = join(packages, 'exports', engine);
    const pages = existsSync(folder) ? readdirSync(folder).filter((name) => /^check.*\.html$/.test(name)).sort() : [];
    if (pages.length === 0) stop(1, `the export for ${engine} has no check page`);
    for (const page of pages) {
        for (const device of table.devices) {
            const messages = [];
            console.error(`opening ${page} of ${engine} on ${device.name}`);
            await row(`${engine} ${page}`, device, messages, async () => onPage(
                { device, webgpu: page.includes('wgsl'), packages, address: server.address, size: table.size, messages },
                async (tab, renderer) => {
                    await tab.goto(`${server.address}exports/${engine}/${page}`);
                    const result = tab.locator('#result');
                    await tab.waitForFunction(() => document.getElementById('result').textContent !== 'running');
                    const said = await result.textContent();
                    const [, verdict, points, max, allowed] =
                        /^(passed|FAILED): (\d+) points, largest difference (\S+), tolerance (\S+)$/.exec(said) ?? [];
                    if (!verdict) throw new Error(`the page says: ${said}`);
                    if ((verdict === 'passed') !== (Number(max) <= Number(allowed))) throw new Error(`the page misjudges: ${said}`);
                    return { renderer: `${renderer}; the page says: ${said}`, pixels: Number(points), max: Number(max),
                        tolerance: Math.max(device.tolerance, Number(allowed)) };
                },
            ));
        }
    }
}
server.close();

if (given.json) {
    console.log(JSON.stringify(results, null, 2));
} else {
    console.log('| client | version | device | pixels | max error | tolerance | |\n|---|---|---|---|---|---|---|');
    for (const row of results.filter((row) => !row.not_run)) {
        console.log(`| ${row.client} | ${row.version} | ${row.device} | ${row.pixels} | ${row.max.toExponential(1)} | ${row.tolerance.toExponential(0)} | ${row.passed ? 'passed' : 'FAILED'} |`);
    }
    for (const row of results) {
        const said = row.not_run ? `not run: ${row.not_run}` : row.error ?? row.renderer;
        if (said) console.log(`${row.client} on ${row.device}: ${said}`);
    }
}
process.exitCode = results.every((row) => row.passed || row.not_run) ? 0 : 1;
