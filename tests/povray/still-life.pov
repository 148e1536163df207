// The still life, for POV-Ray: chapter 8's picture by a renderer that others wrote, in f64.
// `render` beside this file says with which options. What makes the two comparable:
//   light in linear numbers (assumed_gamma, and File_Gamma on the command line); Phong's own
//   highlight (phong, not specular); no rays given up for their weight (adc_bailout 0); glass by
//   Fresnel, whose reflected and transmitted shares add up (conserve_energy), and which casts an
//   opaque shadow, by a twin that only shadow rays can see.
#version 3.7;
#ifndef (DEPTH) #declare DEPTH = 6; #end
global_settings { assumed_gamma 1.0 max_trace_level DEPTH adc_bailout 0 ambient_light rgb 1 }
background { rgb <0.2, 0.5, 0.8> }

#declare Forward = vnormalize(<0, -1.1, 7>);
#declare Right = <1, 0, 0>;
#declare Height = 2 / (1 + sqrt(2)); // of the image plane, at a focal length of 1
camera {
  location <0, 2, -7>
  direction Forward
  up Height * vcross(Forward, Right)
  right (4/3) * Height * Right
}

light_source { <-5, 7, -6> rgb 0.6 }
light_source { < 4, 6, -4> rgb 0.4 }

#macro Plastic(Colour, Ambient, Diffuse, Specular, Shininess, Reflectivity)
  texture {
    pigment { rgb Colour }
    finish { ambient Ambient diffuse Diffuse phong Specular phong_size Shininess reflection { Reflectivity } }
  }
#end

plane {
  y, 0
  texture { pigment { checker rgb 0.1 rgb 0.9 } finish { ambient 0.1 diffuse 0.8 phong 0 } }
}
sphere { <-2.2, 0.8,  1.0>, 0.8 Plastic(<0.9, 0.15, 0.1>, 0.1, 0.8, 0.5, 50, 0) }
sphere { < 0.2, 1.2,  2.0>, 1.2 Plastic(<0.9, 0.9, 0.9>, 0.02, 0.1, 0.8, 200, 0.8) }
sphere { < 2.3, 0.7,  0.6>, 0.7 Plastic(<0.1, 0.7, 0.2>, 0.1, 0.8, 0.5, 50, 0.2) }
sphere { <-0.8, 0.4, -1.0>, 0.4 Plastic(<0.15, 0.2, 0.9>, 0.1, 0.8, 0.8, 100, 0) }

#declare Centre = <0.9, 0.6, -1.2>;
sphere {
  Centre, 0.6
  texture {
    pigment { rgbt 1 }
    finish { ambient 0 diffuse 0 phong 0.8 phong_size 200 reflection { 0, 1 fresnel on } conserve_energy }
  }
  interior { ior 1.5 }
  no_shadow
}
sphere { Centre, 0.5999 pigment { rgb 1 } no_image no_reflection }
