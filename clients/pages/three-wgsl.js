// three.js with WebGPURenderer: the material beside the export is used, and the term that it computes is read.
import * as THREE from 'three/webgpu';
import { normalView, positionViewDirection, property, vec4 } from 'three/tsl';
import { ThinFilmMaterial } from '/engines/three-wgsl/thin-film-material.js';

// The material computes the term when its lights are set up, which is after its output is asked for.
const term = property('vec3', 'thinFilmTerm');

class TermMaterial extends ThinFilmMaterial {
    setupLightingModel() {
        const model = super.setupLightingModel();
        const start = model.start.bind(model);
        model.start = (builder) => {
            start(builder);
            term.assign(model.iridescenceFresnel);
        };
        return model;
    }

    setupOutput(builder, lit) {
        return vec4(lit.rgb.mul(0).add(term), normalView.dot(positionViewDirection).clamp());
    }
}

export async function open(code, size) {
    const renderer = new THREE.WebGPURenderer();
    await renderer.init();
    if (!renderer.backend.isWebGPUBackend) throw new Error('this browser has no WebGPU');
    renderer.setSize(size, size);
    document.body.append(renderer.domElement);
    const target = new THREE.RenderTarget(size, size, { type: THREE.FloatType });
    const camera = new THREE.PerspectiveCamera(40, 1, 0.1, 10);
    camera.position.z = 3.1;
    const geometry = new THREE.SphereGeometry(1, 96, 64);

    function sphere({ color, film_ior, thickness_nm }, Material) {
        const scene = new THREE.Scene();
        scene.add(new THREE.AmbientLight(0xffffff, 1), new THREE.HemisphereLight(0xffffff, 0x222222, 2));
        const light = new THREE.DirectionalLight(0xffffff, 3);
        light.position.set(1, 2, 3);
        scene.add(light);
        const material = new Material(code, {
            metalness: 1, roughness: 0.3, iridescence: 1, iridescenceIOR: film_ior,
            iridescenceThicknessMinimum: thickness_nm, iridescenceThicknessMaximum: thickness_nm,
        });
        material.color.setRGB(...color, THREE.LinearSRGBColorSpace);
        scene.add(new THREE.Mesh(geometry, material));
        return scene;
    }

    return {
        version: THREE.REVISION,
        async term(settings) {
            renderer.setRenderTarget(target);
            renderer.setClearColor(0x000000, 0);
            renderer.render(sphere(settings, TermMaterial), camera);
            const pixels = await renderer.readRenderTargetPixelsAsync(target, 0, 0, size, size);
            renderer.setRenderTarget(null);
            // Rows go up, as those of WebGL do.
            const row = size * 4;
            return pixels.map((_, i) => pixels[(size - 1 - Math.floor(i / row)) * row + i % row]);
        },
        async show(settings) {
            renderer.setClearColor(0x202020, 1);
            renderer.render(sphere(settings, ThinFilmMaterial), camera);
        },
    };
}
