// Bodies of glass half in the water, for POV-Ray: what chapter 11 says about clear bodies in one another, by a
// renderer that others wrote, in f64. `render` beside this file says with which options, and
// still-life.pov what makes light and surfaces comparable.
//
// In the list of chapter 11 a later body displaces the earlier ones: water, a ball of glass, a bubble in it, a lens
// of glass, a lens of ice. POV-Ray goes by another rule: where bodies overlap, the medium is that of the body that the
// ray has entered last, and the media absorb together. So here each body is cut out of the earlier ones. Where two
// of them meet, they overlap by a hundred-thousandth of a unit, so that a ray enters the one before it leaves the
// other; the second of these two surfaces is hidden, which is to say that it does not reflect: POV-Ray's own
// refraction takes it for none, but its Fresnel reflection does not. The scene is 1000 times as large as ours, for
// POV-Ray overlooks surfaces less than 0.0001 apart.
//
// A medium absorbs by e^(-a d); fade_power 1001 would do so only to light that leaves the body.
#version 3.7;
global_settings { assumed_gamma 1.0 max_trace_level 40 adc_bailout 1e-6 ambient_light rgb 1 }
background { rgb <0.2, 0.5, 0.8> }

#declare Unit = 1000;
#declare Overlap = 1e-5 * Unit;

#declare Forward = vnormalize(<0, -2.3, 6>);
#declare Right = <1, 0, 0>;
#declare Height = 2 / (1 + sqrt(2)); // of the image plane, at a focal length of 1
camera {
  location Unit * <0, 2.3, -6>
  direction Forward
  up Height * vcross(Forward, Right)
  right (4/3) * Height * Right
}

light_source { Unit * <-3, 6, -4> rgb 0.6 }
light_source { Unit * < 4, 5, -2> rgb 0.5 }

// The bottom, and a red ball on it.
plane {
  y, -1.6 * Unit
  texture { pigment { checker rgb 0.15 rgb 0.85 scale Unit } finish { ambient 0.1 diffuse 0.8 phong 0 } }
  hollow
}
sphere {
  Unit * <1.1, -0.9, 1.2>, 0.7 * Unit
  texture {
    pigment { rgb <0.9, 0.15, 0.1> }
    finish { ambient 0.1 diffuse 0.8 phong 0.5 phong_size 50 reflection { 0.3 } }
  }
  hollow
}

#declare Interface = texture {
  pigment { rgbt 1 }
  finish { ambient 0 diffuse 0 phong 0.8 phong_size 200 reflection { 0, 1 fresnel on } conserve_energy }
}
#declare Hidden = texture { pigment { rgbt 1 } finish { ambient 0 diffuse 0 } }

// A hole for a later body: from inside the earlier body, its surface is hidden.
#macro Hole() texture { Interface } interior_texture { Hidden } #end
// The surface of a body in a hole of others: where it is in one of these, it is hidden from inside the body.
#macro In(Others) texture { Interface } interior_texture { object { Others texture { Interface } texture { Hidden } } } #end
#macro Medium(Index, Absorption) interior { ior Index media { absorption Absorption / Unit } } hollow #end

#macro Sphere(Centre, Radius, Shrunk) Unit * Centre, Radius * Unit - Shrunk #end
#macro Ball(Shrunk) Sphere(<-0.9, 0.1, 0.3>, 0.9, Shrunk) #end
#macro Lens(Shrunk) Sphere(<0.8, 0.15, -0.9>, 0.5, Shrunk) #end
#macro Ice(Shrunk) Sphere(<1.3, 0.35, -0.8>, 0.45, Shrunk) #end

#declare Water = difference {
  plane { y, 0 texture { Interface } }
  sphere { Ball(Overlap) Hole() }
  sphere { Lens(Overlap) Hole() }
  sphere { Ice(Overlap) Hole() }
}
#declare Glass = difference {
  sphere { Lens(0) In(Water) }
  sphere { Ice(Overlap) Hole() }
}
object { Water Medium(1.33, <0.5, 0.15, 0.1>) }
difference {
  sphere { Ball(0) In(Water) }
  sphere { Sphere(<-0.8, 0.25, 0.2>, 0.45, 0) texture { Interface } }
  Medium(1.5, <0.3, 0.1, 0.5>)
}
object { Glass Medium(1.7, <0.1, 0.6, 0.6>) }
sphere { Ice(0) In(union { object { Water } object { Glass } }) Medium(1.31, 0) }
