// Renders the exports in their engines, in a headless Chromium, and compares each pixel with the CPU evaluation.
//
// Usage: node clients/run.mjs --pavo PAVO --packages DIR [--json] [NAME ...]
// DIR has node_modules; exports, points and screenshots go into it. Exit codes are those of the command pavo.

import { execFileSync, spawnSync } from 'node:child_process';
import { existsSync, mkdirSync, readFileSync, writeFileSync } from 'node:fs';
import { createServer } from 'node:http';
import { createRequire } from 'node:module';
import { dirname, extname, join, normalize, resolve } from 'node:path';
import { fileURLToPath } from 'node:url';
import { parseArgs } from 'node:util';

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

const browserPath = ['chromium', 'chromium-browser', 'google-chrome']
    .map((name) => spawnSync('sh', ['-c', `command -v ${name}`], { encoding: 'utf8' }).stdout.trim())
    .find((path) => path !== '');
if (!browserPath) stop(3, 'no Chromium is here; on Debian, `apt-get install chromium` brings it. Nothing was rendered');
for (const device of table.devices) {
    const driver = device.environment.VK_DRIVER_FILES;
    if (driver && !existsSync(driver)) {
        stop(3, `${driver} is not here; on Debian, \`apt-get install mesa-vulkan-drivers\` brings it. Nothing was rendered`);
    }
}
const require = createRequire(join(packages, 'package.json'));
let chromium;
try {
    ({ chromium } = require('playwright-core'));
} catch {
    stop(3, `the npm package playwright-core is not in ${packages}. Nothing was rendered`);
}

const kinds = { '.html': 'text/html', '.js': 'text/javascript', '.mjs': 'text/javascript' };
const templates = join(here, '..', 'templates');
const page = `<!doctype html><meta charset="utf-8"><title>client</title>
<style>body { margin: 0 } canvas { display: block }</style>
<script type="importmap">${JSON.stringify({ imports: table.imports })}</script>`;
const server = createServer((request, response) => {
    const path = normalize(decodeURIComponent(new URL(request.url, 'http://localhost').pathname));
    if (path === '/') return response.setHeader('content-type', 'text/html').end(page);
    const root = path.startsWith('/node_modules/') ? packages : path.startsWith('/engines/') ? templates : here;
    try {
        const body = readFileSync(join(root, path));
        return response.setHeader('content-type', kinds[extname(path)] ?? 'text/plain').end(body);
    } catch {
        return response.writeHead(404).end();
    }
});
await new Promise((done) => { server.listen(0, '127.0.0.1', done); });
const address = `http://127.0.0.1:${server.address().port}/`;

// The CPU evaluation of the scene at points, by the command.
function evaluated(points, name) {
    const header = 'cos_theta1,film_ior,thickness_nm,base_color_r,base_color_g,base_color_b';
    const file = join(packages, 'points', `${name}.csv`);
    writeFileSync(file, `${header}\n${points.map((point) => point.join(',')).join('\n')}\n`);
    const text = execFileSync(given.pavo, ['eval', join(here, 'scene.toml'), '--points', file, '--on', 'cpu-f64'],
        { encoding: 'utf8', maxBuffer: 1 << 28, stdio: ['ignore', 'pipe', 'inherit'] });
    const rows = text.split('\n').filter((line) => line !== '' && !line.startsWith('#'));
    const columns = rows[0].split(',');
    const at = ['r', 'g', 'b'].map((name) => columns.indexOf(name));
    return rows.slice(1).map((row) => { const fields = row.split(','); return at.map((i) => Number(fields[i])); });
}

for (const folder of ['exports', 'points', 'screenshots']) mkdirSync(join(packages, folder), { recursive: true });
const results = [];
for (const client of clients) {
    for (const device of table.devices) {
        const flags = client.webgpu ? device.webgpu : device.flags;
        // WebGPU is only asked for where the browser takes that device for it.
        if (!flags) continue;
        const name = `${client.name}-${device.name}`;
        console.error(`rendering ${name}`);
        const result = { client: client.name, version: '', device: device.name, pixels: 0, max: Infinity, tolerance: device.tolerance, passed: false };
        results.push(result);
        const messages = [];
        let browser;
        try {
            const folder = join(packages, 'exports', client.engine);
            execFileSync(given.pavo, ['export', join(here, 'scene.toml'), '--engine', client.engine, '-o', folder],
                { stdio: ['ignore', 'ignore', 'inherit'] });
            const code = readFileSync(join(folder, client.file), 'utf8');
            browser = await chromium.launch({
                executablePath: browserPath,
                args: ['--no-sandbox', '--disable-quic', '--no-first-run', '--disable-background-networking', ...flags],
                env: { ...process.env, ...device.environment },
            });
            const tab = await browser.newPage({ viewport: { width: table.size, height: table.size } });
            tab.on('console', (message) => messages.push(message.text()));
            tab.on('pageerror', (error) => messages.push(error.message));
            await tab.goto(address);
            const about = await tab.evaluate(async ([module, code, size]) => {
                window.client = await (await import(module)).open(code, size);
                return { version: String(window.client.version), renderer: window.client.device };
            }, [`/pages/${client.page}.js`, code, table.size]);
            Object.assign(result, about);
            let worst = 0;
            let pixels = 0;
            for (const settings of table.settings) {
                const term = await tab.evaluate(async (settings) => Array.from(await window.client.term(settings)), settings);
                const points = [];
                const found = [];
                for (let i = 0; i < term.length; i += 4) {
                    // Outside of the sphere nothing is drawn; at the rim a cosine of 0 shows no film.
                    if (!(term[i + 3] > 0.01)) continue;
                    points.push([term[i + 3], Math.fround(settings.film_ior), settings.thickness_nm, ...settings.color.map(Math.fround)]);
                    found.push(term.slice(i, i + 3));
                }
                if (points.length < table.size * table.size / 4) throw new Error(`the sphere has ${points.length} pixels only`);
                const expected = evaluated(points, name);
                if (expected.length !== found.length) throw new Error('the evaluation has another number of points');
                for (let i = 0; i < found.length; ++i) {
                    for (let c = 0; c < 3; ++c) {
                        const difference = Math.abs(found[i][c] - expected[i][c]);
                        if (!(difference <= worst)) worst = difference;
                    }
                }
                pixels += points.length;
            }
            await tab.evaluate((settings) => window.client.show(settings), table.settings[1]);
            await tab.screenshot({ path: join(packages, 'screenshots', `${name}.png`) });
            Object.assign(result, { pixels, max: worst, passed: worst <= device.tolerance });
        } catch (error) {
            result.error = error.message;
            console.error(`${name}: ${error.message}\n${messages.slice(0, 20).join('\n')}`);
        } finally {
            await browser?.close();
        }
    }
}
server.close();

if (given.json) {
    console.log(JSON.stringify(results, null, 2));
} else {
    console.log('| client | version | device | pixels | max error | tolerance | |\n|---|---|---|---|---|---|---|');
    for (const row of results) {
        console.log(`| ${row.client} | ${row.version} | ${row.device} | ${row.pixels} | ${row.max.toExponential(1)} | ${row.tolerance.toExponential(0)} | ${row.passed ? 'passed' : 'FAILED'} |`);
    }
    for (const row of results) console.log(`${row.client} on ${row.device}: ${row.renderer ?? row.error}`);
}
process.exitCode = results.every((row) => row.passed) ? 0 : 1;
