// A MeshPhysicalNodeMaterial whose film is that of thin_film.wgsl, for three.js's WebGPURenderer.
//
//   const code = await (await fetch('thin_film.wgsl')).text();
//   const material = new ThinFilmMaterial(code, { metalness: 1, iridescence: 1, iridescenceIOR: 1.33 });
import { MeshPhysicalNodeMaterial, PhysicalLightingModel } from 'three/webgpu';
import {
    diffuseColor, float, iridescenceIOR, iridescenceThickness, metalness, mix, normalView, positionViewDirection,
    specularColor, wgsl, wgslFn,
} from 'three/tsl';

// Reflectance at normal incidence of which Schlick's approximation gives this at the angle, as three.js has it.
function f0OfSchlick(f, cosine) {
    const weight = cosine.oneMinus().clamp().pow(5).clamp(0, 0.9999);
    return f.sub(weight).div(weight.oneMinus());
}

class ThinFilmLightingModel extends PhysicalLightingModel {
    constructor(evaluate, features) {
        super(...features);
        this.evaluate = evaluate;
    }

    start(builder) {
        const cosTheta1 = normalView.dot(positionViewDirection).clamp();
        const film = (baseF0) => this.evaluate({
            outsideIOR: float(1), eta2: iridescenceIOR, cosTheta1, thinFilmThickness: iridescenceThickness, baseF0,
        });
        const dielectric = film(specularColor);
        const metallic = film(diffuseColor.rgb);
        super.start(builder);
        this.iridescenceFresnel = mix(dielectric, metallic, metalness);
        this.iridescenceF0Dielectric = f0OfSchlick(dielectric, cosTheta1);
        this.iridescenceF0Metallic = f0OfSchlick(metallic, cosTheta1);
    }
}

export class ThinFilmMaterial extends MeshPhysicalNodeMaterial {
    constructor(code, parameters) {
        super(parameters);
        // three.js reads the first declaration of a text only: the function itself, then what it calls.
        const entry = code.match(/^fn evalIridescence\([\s\S]*?^}/m)[0];
        this.evaluate = wgslFn(entry, [wgsl(code.replace(entry, ''))]);
    }

    setupLightingModel() {
        const features = [
            this.useClearcoat, this.useSheen, this.useIridescence, this.useAnisotropy, this.useTransmission,
            this.useDispersion,
        ];
        this.filmModel = new ThinFilmLightingModel(this.evaluate, features);
        return this.filmModel;
    }
}
