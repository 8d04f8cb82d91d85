// PlayCanvas on WebGL or WebGPU: the chunk of the material is replaced.
import * as pc from 'playcanvas';

export async function open(code, size, webgpu) {
    const language = webgpu ? pc.SHADERLANGUAGE_WGSL : pc.SHADERLANGUAGE_GLSL;
    const canvas = document.createElement('canvas');
    canvas.width = canvas.height = size;
    document.body.append(canvas);
    const device = await pc.createGraphicsDevice(canvas, {
        deviceTypes: [webgpu ? pc.DEVICETYPE_WEBGPU : pc.DEVICETYPE_WEBGL2], preserveDrawingBuffer: true, antialias: false,
    });
    if (device.isWebGPU !== webgpu) throw new Error('this browser has no WebGPU');
    const options = new pc.AppOptions();
    options.graphicsDevice = device;
    options.componentSystems = [pc.RenderComponentSystem, pc.CameraComponentSystem, pc.LightComponentSystem];
    const app = new pc.AppBase(canvas);
    app.init(options);
    app.setCanvasFillMode(pc.FILLMODE_NONE, size, size);
    app.setCanvasResolution(pc.RESOLUTION_FIXED, size, size);
    app.autoRender = false;
    app.start();
    app.scene.ambientLight = new pc.Color(0.3, 0.3, 0.3);

    const camera = new pc.Entity();
    camera.addComponent('camera', { fov: 40, nearClip: 0.1, clearColor: new pc.Color(0, 0, 0, 0) });
    camera.setPosition(0, 0, 3.1);
    app.root.addChild(camera);
    const light = new pc.Entity();
    light.addComponent('light', { type: 'directional', intensity: 2 });
    light.setEulerAngles(45, 30, 0);
    app.root.addChild(light);
    const sphere = new pc.Entity();
    sphere.addComponent('render', { type: 'sphere' });
    sphere.setLocalScale(2, 2, 2);
    app.root.addChild(sphere);

    const buffer = new pc.Texture(device, {
        width: size, height: size, format: pc.PIXELFORMAT_RGBA32F, mipmaps: false,
        minFilter: pc.FILTER_NEAREST, magFilter: pc.FILTER_NEAREST,
    });
    const target = new pc.RenderTarget({ colorBuffer: buffer, depth: true });

    function material({ color, film_ior, thickness_nm }, shown) {
        const made = new pc.StandardMaterial();
        made.useMetalness = true;
        made.metalness = 1;
        made.gloss = 0.7;
        // The engine takes colours as sRGB.
        const encoded = color.map((x) => x ** (1 / 2.2));
        made.diffuse = new pc.Color(...encoded);
        made.useIridescence = true;
        made.iridescence = 1;
        made.iridescenceRefractionIndex = film_ior;
        made.iridescenceThicknessMin = thickness_nm;
        made.iridescenceThicknessMax = thickness_nm;
        const chunks = made.getShaderChunks(language);
        chunks.set('iridescenceDiffractionPS', code);
        if (!shown) {
            const engine = pc.ShaderChunks.get(device, language).get('litForwardBackendPS');
            const [target, vec4, last] = webgpu ? ['output.color', 'vec4f', 'return output;'] : ['gl_FragColor', 'vec4', '}'];
            const end = engine.lastIndexOf(last);
            chunks.set('litForwardBackendPS', `${engine.slice(0, end)}
                ${target} = ${vec4}(iridescenceFresnel, saturate(dot(dViewDirW, litArgs_worldNormal)));
                ${engine.slice(end)}`);
        }
        made.shaderChunksVersion = '2.23';
        made.update();
        return made;
    }

    async function render() {
        app.update(1 / 60);
        app.render();
    }

    return {
        version: pc.version,
        async term(settings) {
            sphere.render.material = material(settings, false);
            camera.camera.renderTarget = target;
            await render();
            await render();
            const pixels = await buffer.read(0, 0, size, size, { renderTarget: target, immediate: true });
            camera.camera.renderTarget = null;
            return new Float32Array(pixels);
        },
        async show(settings) {
            sphere.render.material = material(settings, true);
            await render();
            await render();
        },
    };
}
