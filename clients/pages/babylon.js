// Babylon.js on WebGL or WebGPU: a plugin of the material puts the exported function in place of the engine's.
import { Engine } from '@babylonjs/core/Engines/engine.js';
import { Scene } from '@babylonjs/core/scene.js';
import { ArcRotateCamera } from '@babylonjs/core/Cameras/arcRotateCamera.js';
import { HemisphericLight } from '@babylonjs/core/Lights/hemisphericLight.js';
import { DirectionalLight } from '@babylonjs/core/Lights/directionalLight.js';
import { PBRMaterial } from '@babylonjs/core/Materials/PBR/pbrMaterial.js';
import { MaterialPluginBase } from '@babylonjs/core/Materials/materialPluginBase.js';
import { RenderTargetTexture } from '@babylonjs/core/Materials/Textures/renderTargetTexture.js';
import { CreateSphere } from '@babylonjs/core/Meshes/Builders/sphereBuilder.js';
import { Color3, Color4 } from '@babylonjs/core/Maths/math.color.js';
import { Vector3 } from '@babylonjs/core/Maths/math.vector.js';
import { Constants } from '@babylonjs/core/Engines/constants.js';

let exported = '';
let term = false;
let vec4 = 'vec4';

class ThinFilm extends MaterialPluginBase {
    constructor(material) {
        super(material, 'ThinFilm', 200, { THIN_FILM: false });
        this._enable(true);
    }

    getClassName() { return 'ThinFilm'; }

    isCompatible() { return true; }

    getCustomCode(kind) {
        if (kind !== 'fragment') return null;
        const code = {
            CUSTOM_FRAGMENT_DEFINITIONS: exported,
            // The engine's call, not its definition.
            '!=evalIridescence\\(': '=pavo_evalIridescence(',
        };
        if (term) {
            code.CUSTOM_FRAGMENT_BEFORE_FRAGCOLOR =
                `finalColor = ${vec4}(iridescenceOut.specularEnvironmentR0, NdotVUnclamped);`;
        }
        return code;
    }
}

async function engineOn(canvas, webgpu) {
    if (!webgpu) return new Engine(canvas, true, { preserveDrawingBuffer: true });
    const { WebGPUEngine } = await import('@babylonjs/core/Engines/webgpuEngine.js');
    await import('@babylonjs/core/Engines/WebGPU/Extensions/index.js');
    const engine = new WebGPUEngine(canvas, { antialias: true });
    await engine.initAsync();
    return engine;
}

export async function open(code, size, webgpu) {
    exported = code;
    vec4 = webgpu ? 'vec4f' : 'vec4';
    const canvas = document.createElement('canvas');
    canvas.width = canvas.height = size;
    document.body.append(canvas);
    const engine = await engineOn(canvas, webgpu);
    engine.setSize(size, size);

    function sphere({ color, film_ior, thickness_nm }) {
        const scene = new Scene(engine);
        const camera = new ArcRotateCamera('camera', Math.PI / 2, Math.PI / 2, 3.1, Vector3.Zero(), scene);
        camera.fov = 0.7;
        camera.minZ = 0.1;
        new HemisphericLight('sky', new Vector3(0, 1, 0), scene).intensity = 1;
        new DirectionalLight('sun', new Vector3(-1, -2, -3), scene).intensity = 2;
        const mesh = CreateSphere('sphere', { diameter: 2, segments: 48 }, scene);
        const material = new PBRMaterial('film', scene);
        material.metallic = 1;
        material.roughness = 0.3;
        material.albedoColor = new Color3(...color);
        material.iridescence.isEnabled = true;
        material.iridescence.intensity = 1;
        material.iridescence.indexOfRefraction = film_ior;
        material.iridescence.minimumThickness = thickness_nm;
        material.iridescence.maximumThickness = thickness_nm;
        new ThinFilm(material);
        mesh.material = material;
        return { scene, camera, mesh };
    }

    return {
        version: Engine.Version,
        async term(settings) {
            term = true;
            const { scene, camera, mesh } = sphere(settings);
            const target = new RenderTargetTexture('term', size, scene, {
                type: Constants.TEXTURETYPE_FLOAT, format: Constants.TEXTUREFORMAT_RGBA, samplingMode: 1,
                generateMipMaps: false,
            });
            target.clearColor = new Color4(0, 0, 0, 0);
            target.renderList = [mesh];
            target.activeCamera = camera;
            mesh.material.disableDepthWrite = false;
            await scene.whenReadyAsync();
            await mesh.material.forceCompilationAsync(mesh);
            target.render();
            const pixels = new Float32Array(await target.readPixels());
            scene.dispose();
            return pixels;
        },
        async show(settings) {
            term = false;
            const { scene } = sphere(settings);
            await scene.whenReadyAsync();
            scene.render();
        },
    };
}
