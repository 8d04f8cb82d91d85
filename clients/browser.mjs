// A headless Chromium on one of the devices, and the pages that it is shown.

import { spawnSync } from 'node:child_process';
import { existsSync, readFileSync } from 'node:fs';
import { createServer } from 'node:http';
import { createRequire } from 'node:module';
import { extname, join, normalize } from 'node:path';

// What WebGL draws with: the device that WebGPU has it from need not say.
const renderer = () => {
    const gl = document.createElement('canvas').getContext('webgl2');
    const info = gl?.getExtension('WEBGL_debug_renderer_info');
    return info ? gl.getParameter(info.UNMASKED_RENDERER_WEBGL) : 'no WebGL';
};

// WebGPU on top of OpenGL ES is of the level that it calls compatibility, which has to be asked for.
const askForCompatibility = () => {
    if (!globalThis.GPU) return;
    const ask = GPU.prototype.requestAdapter;
    GPU.prototype.requestAdapter = function requestAdapter(options) {
        return ask.call(this, { ...options, featureLevel: 'compatibility' });
    };
};

/// What is missing of a browser and the devices' drivers, in words; nothing where all is there.
export function missing(devices, packages) {
    if (!path()) return 'no Chromium is here; on Debian, `apt-get install chromium` brings it';
    const drivers = devices.map((device) => device.environment.VK_DRIVER_FILES).filter((driver) => driver);
    const absent = drivers.find((driver) => !existsSync(driver));
    if (absent) return `${absent} is not here; on Debian, \`apt-get install mesa-vulkan-drivers\` brings it`;
    try {
        createRequire(join(packages, 'package.json')).resolve('playwright-core');
    } catch {
        return `the npm package playwright-core is not in ${packages}`;
    }
    return '';
}

function path() {
    return ['chromium', 'chromium-browser', 'google-chrome']
        .map((name) => spawnSync('sh', ['-c', `command -v ${name}`], { encoding: 'utf8' }).stdout.trim())
        .find((found) => found !== '');
}

/// Opens a page on a device and lets `use` do with it; what the page says goes into `messages`. `use` also gets what the
/// device calls itself: another device than the one that was asked for is refused.
export async function onPage({ device, webgpu, packages, address, size, messages }, use) {
    const { chromium } = createRequire(join(packages, 'package.json'))('playwright-core');
    const browser = await chromium.launch({
        executablePath: path(),
        args: ['--no-sandbox', '--disable-quic', '--no-first-run', '--disable-background-networking',
            ...(webgpu ? device.webgpu : device.flags)],
        env: { ...process.env, ...device.environment },
    });
    try {
        const tab = await browser.newPage({ viewport: { width: size, height: size } });
        tab.on('console', (message) => messages.push(message.text()));
        tab.on('pageerror', (error) => messages.push(error.message));
        if (webgpu && device.compatibility) await tab.addInitScript(askForCompatibility);
        await tab.goto(address);
        const found = await tab.evaluate(renderer);
        if (!found.includes(device.renderer)) throw new Error(`the browser draws with ${found}, not with ${device.renderer}`);
        if (webgpu) {
            const adapter = await tab.evaluate(async () => (await navigator.gpu?.requestAdapter())?.info.architecture);
            if (adapter === undefined) throw new Error('this browser has no WebGPU');
            if (device.name !== 'swiftshader' && adapter === 'swiftshader') throw new Error('WebGPU is on SwiftShader');
        }
        return await use(tab, found);
    } finally {
        await browser.close();
    }
}

/// Serves the clients' own files, the engines of `packages`, the templates and the exports; the address.
export async function serve({ here, packages, imports }) {
    const kinds = { '.html': 'text/html', '.js': 'text/javascript', '.mjs': 'text/javascript' };
    const blank = `<!doctype html><meta charset="utf-8"><title>client</title>
<style>body { margin: 0 } canvas { display: block }</style>
<script type="importmap">${JSON.stringify({ imports })}</script>`;
    const roots = { node_modules: packages, exports: packages, engines: join(here, '..', 'templates') };
    const server = createServer((request, response) => {
        const asked = normalize(decodeURIComponent(new URL(request.url, 'http://localhost').pathname));
        if (asked === '/') return response.setHeader('content-type', 'text/html').end(blank);
        try {
            const body = readFileSync(join(roots[asked.split('/')[1]] ?? here, asked));
            return response.setHeader('content-type', kinds[extname(asked)] ?? 'text/plain').end(body);
        } catch {
            return response.writeHead(404).end();
        }
    });
    await new Promise((done) => { server.listen(0, '127.0.0.1', done); });
    return { address: `http://127.0.0.1:${server.address().port}/`, close: () => server.close() };
}
