// three.js with WebGLRenderer: its chunk is replaced, and the term that its material computes is read from a sphere.
import * as THREE from 'three';

export async function open(code, size) {
    THREE.ShaderChunk.iridescence_fragment = code;
    const renderer = new THREE.WebGLRenderer({ preserveDrawingBuffer: true });
    renderer.setSize(size, size);
    document.body.append(renderer.domElement);
    const target = new THREE.WebGLRenderTarget(size, size, { type: THREE.FloatType });
    const camera = new THREE.PerspectiveCamera(40, 1, 0.1, 10);
    camera.position.z = 3.1;
    const geometry = new THREE.SphereGeometry(1, 96, 64);

    function sphere({ color, film_ior, thickness_nm }, shown) {
        const scene = new THREE.Scene();
        scene.add(new THREE.AmbientLight(0xffffff, 1), new THREE.HemisphereLight(0xffffff, 0x222222, 2));
        const light = new THREE.DirectionalLight(0xffffff, 3);
        light.position.set(1, 2, 3);
        scene.add(light);
        const material = new THREE.MeshPhysicalMaterial({
            metalness: 1, roughness: 0.3, iridescence: 1, iridescenceIOR: film_ior,
            iridescenceThicknessMinimum: thickness_nm, iridescenceThicknessMaximum: thickness_nm,
        });
        material.color.setRGB(...color, THREE.LinearSRGBColorSpace);
        if (!shown) {
            material.onBeforeCompile = (shader) => {
                shader.fragmentShader = shader.fragmentShader.replace(
                    '#include <dithering_fragment>', 'gl_FragColor = vec4(material.iridescenceFresnel, dotNVi);');
            };
            material.customProgramCacheKey = () => 'term';
        }
        scene.add(new THREE.Mesh(geometry, material));
        return scene;
    }

    return {
        version: THREE.REVISION,
        async term(settings) {
            renderer.setRenderTarget(target);
            renderer.setClearColor(0x000000, 0);
            renderer.clear();
            renderer.render(sphere(settings, false), camera);
            const pixels = new Float32Array(size * size * 4);
            renderer.readRenderTargetPixels(target, 0, 0, size, size, pixels);
            renderer.setRenderTarget(null);
            return pixels;
        },
        async show(settings) {
            renderer.setClearColor(0x202020, 1);
            renderer.render(sphere(settings, true), camera);
        },
    };
}
