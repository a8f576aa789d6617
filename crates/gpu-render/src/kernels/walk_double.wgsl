// Compiled from walk.slang by `cargo xtask kernels`. Not to be edited.
// compiler: Slang 2026.12 in slangpy 0.43.1
// source: d1a41197f8e44bac
// result: c0ee82d8741655aa

struct Launch_std140_0
{
    @align(16) first_0 : u32,
    @align(4) end_0 : u32,
    @align(8) room_0 : u32,
    @align(4) depth_0 : u32,
};

@binding(8) @group(0) var<uniform> launch_0 : Launch_std140_0;
@binding(5) @group(0) var<storage, read> input_0 : array<u32>;

@binding(6) @group(0) var<storage, read_write> paths_0 : array<u32>;

@binding(4) @group(0) var<storage, read> scene_0 : array<u32>;

@binding(2) @group(0) var<storage, read> primitives_0 : array<f64>;

@binding(0) @group(0) var<storage, read> nodes_0 : array<vec4<u32>>;

@binding(1) @group(0) var<storage, read> leaf_starts_0 : array<u32>;

@binding(3) @group(0) var<storage, read> rough_0 : array<vec4<u32>>;

@binding(7) @group(0) var<storage, read_write> sums_0 : array<atomic<u32>>;

struct DiffPair_float_0
{
     primal_0 : f32,
     differential_0 : f32,
};

struct DiffPair_vectorx3Cfloatx2C3x3E_0
{
     primal_0 : vec3<f32>,
     differential_0 : vec3<f32>,
};

fn _d_sqrt_0( dpx_0 : DiffPair_float_0) -> DiffPair_float_0
{
    var _S1 : DiffPair_float_0 = DiffPair_float_0( sqrt(dpx_0.primal_0), 0.5f / sqrt(max(1.00000001168609742e-07f, dpx_0.primal_0)) * dpx_0.differential_0 );
    return _S1;
}

fn s_fwd_length_impl_0( dpx_1 : DiffPair_vectorx3Cfloatx2C3x3E_0) -> DiffPair_float_0
{
    var _S2 : f32 = dpx_1.primal_0[i32(0)];
    var _S3 : f32 = dpx_1.differential_0[i32(0)] * dpx_1.primal_0[i32(0)];
    var _S4 : f32 = dpx_1.primal_0[i32(1)];
    var _S5 : f32 = dpx_1.differential_0[i32(1)] * dpx_1.primal_0[i32(1)];
    var _S6 : f32 = dpx_1.primal_0[i32(2)];
    var _S7 : f32 = dpx_1.differential_0[i32(2)] * dpx_1.primal_0[i32(2)];
    var _S8 : DiffPair_float_0 = DiffPair_float_0( _S2 * _S2 + _S4 * _S4 + _S6 * _S6, _S3 + _S3 + (_S5 + _S5) + (_S7 + _S7) );
    var _S9 : DiffPair_float_0 = _d_sqrt_0(_S8);
    var _S10 : DiffPair_float_0 = DiffPair_float_0( _S9.primal_0, _S9.differential_0 );
    return _S10;
}

fn s_fwd_normalize_impl_0( dpx_2 : DiffPair_vectorx3Cfloatx2C3x3E_0) -> DiffPair_vectorx3Cfloatx2C3x3E_0
{
    var _S11 : DiffPair_vectorx3Cfloatx2C3x3E_0 = DiffPair_vectorx3Cfloatx2C3x3E_0( dpx_2.primal_0, dpx_2.differential_0 );
    var _S12 : DiffPair_float_0 = s_fwd_length_impl_0(_S11);
    var _S13 : vec3<f32> = vec3<f32>((1.0f / _S12.primal_0));
    var _S14 : DiffPair_vectorx3Cfloatx2C3x3E_0 = DiffPair_vectorx3Cfloatx2C3x3E_0( dpx_2.primal_0 * _S13, dpx_2.differential_0 * _S13 + vec3<f32>(((0.0f - _S12.differential_0) / (_S12.primal_0 * _S12.primal_0))) * dpx_2.primal_0 );
    return _S14;
}

fn _d_dot_0( dpx_3 : DiffPair_vectorx3Cfloatx2C3x3E_0,  dpy_0 : DiffPair_vectorx3Cfloatx2C3x3E_0) -> DiffPair_float_0
{
    var _S15 : DiffPair_float_0 = DiffPair_float_0( dpx_3.primal_0[i32(0)] * dpy_0.primal_0[i32(0)] + dpx_3.primal_0[i32(1)] * dpy_0.primal_0[i32(1)] + dpx_3.primal_0[i32(2)] * dpy_0.primal_0[i32(2)], dpx_3.primal_0[i32(0)] * dpy_0.differential_0[i32(0)] + dpy_0.primal_0[i32(0)] * dpx_3.differential_0[i32(0)] + dpx_3.primal_0[i32(1)] * dpy_0.differential_0[i32(1)] + dpy_0.primal_0[i32(1)] * dpx_3.differential_0[i32(1)] + dpx_3.primal_0[i32(2)] * dpy_0.differential_0[i32(2)] + dpy_0.primal_0[i32(2)] * dpx_3.differential_0[i32(2)] );
    return _S15;
}

fn _d_max_0( dpx_4 : DiffPair_float_0,  dpy_1 : DiffPair_float_0) -> DiffPair_float_0
{
    var _S16 : f32 = max(dpx_4.primal_0, dpy_1.primal_0);
    var _S17 : f32;
    if((dpx_4.primal_0) > (dpy_1.primal_0))
    {
        _S17 = dpx_4.differential_0;
    }
    else
    {
        if((dpx_4.primal_0) < (dpy_1.primal_0))
        {
            _S17 = dpy_1.differential_0;
        }
        else
        {
            _S17 = 0.5f * (dpx_4.differential_0 + dpy_1.differential_0);
        }
    }
    var _S18 : DiffPair_float_0 = DiffPair_float_0( _S16, _S17 );
    return _S18;
}

fn _d_abs_0( dpx_5 : DiffPair_float_0) -> DiffPair_float_0
{
    var _S19 : DiffPair_float_0 = DiffPair_float_0( abs(dpx_5.primal_0), select(select(-1.0f, 0.0f, (dpx_5.primal_0) == 0.0f), 1.0f, (dpx_5.primal_0) > 0.0f) * dpx_5.differential_0 );
    return _S19;
}

fn _d_cross_0( a_0 : DiffPair_vectorx3Cfloatx2C3x3E_0,  b_0 : DiffPair_vectorx3Cfloatx2C3x3E_0) -> DiffPair_vectorx3Cfloatx2C3x3E_0
{
    var _S20 : f32 = a_0.primal_0.y;
    var _S21 : f32 = b_0.primal_0.z;
    var _S22 : f32 = a_0.primal_0.z;
    var _S23 : f32 = b_0.primal_0.y;
    var _S24 : f32 = a_0.differential_0.y;
    var _S25 : f32 = b_0.differential_0.z;
    var _S26 : f32 = a_0.differential_0.z;
    var _S27 : f32 = b_0.differential_0.y;
    var _S28 : f32 = b_0.primal_0.x;
    var _S29 : f32 = a_0.primal_0.x;
    var _S30 : f32 = b_0.differential_0.x;
    var _S31 : f32 = a_0.differential_0.x;
    var _S32 : DiffPair_vectorx3Cfloatx2C3x3E_0 = DiffPair_vectorx3Cfloatx2C3x3E_0( vec3<f32>(_S20 * _S21 - _S22 * _S23, _S22 * _S28 - _S29 * _S21, _S29 * _S23 - _S20 * _S28), vec3<f32>(_S24 * _S21 + _S20 * _S25 - _S26 * _S23 - _S22 * _S27, _S26 * _S28 + _S22 * _S30 - _S31 * _S21 - _S29 * _S25, _S31 * _S23 + _S29 * _S27 - _S24 * _S28 - _S20 * _S30) );
    return _S32;
}

fn path_word_0( path_0 : u32,  which_0 : u32) -> u32
{
    return paths_0[which_0 * launch_0.room_0 + path_0];
}

fn path_vector_0( path_1 : u32,  which_1 : ptr<function, u32>) -> vec3<f32>
{
    var _S33 : u32 = (*which_1) + u32(3);
    (*which_1) = _S33;
    return (bitcast<vec3<f32>>((vec3<u32>(path_word_0(path_1, _S33 - u32(3)), path_word_0(path_1, _S33 - u32(2)), path_word_0(path_1, _S33 - u32(1))))));
}

fn path_vector_1( path_2 : u32,  which_2 : ptr<function, u32>) -> vec3<f32>
{
    var _S34 : u32 = (*which_2) + u32(3);
    (*which_2) = _S34;
    return (bitcast<vec3<f32>>((vec3<u32>(path_word_0(path_2, _S34 - u32(3)), path_word_0(path_2, _S34 - u32(2)), path_word_0(path_2, _S34 - u32(1))))));
}

struct Vector_0
{
     value_0 : vec3<f32>,
     change_0 : vec3<f32>,
};

fn changing_0( value_1 : vec3<f32>,  change_1 : vec3<f32>) -> Vector_0
{
    var vector_0 : Vector_0;
    vector_0.value_0 = value_1;
    vector_0.change_0 = change_1;
    return vector_0;
}

fn path_changing_0( path_3 : u32,  which_3 : ptr<function, u32>) -> Vector_0
{
    var value_2 : vec3<f32> = path_vector_1(path_3, &((*which_3)));
    var _S35 : vec3<f32> = path_vector_1(path_3, &((*which_3)));
    return changing_0(value_2, _S35);
}

struct Place_0
{
     triangle_0 : u32,
     v_0 : f32,
     w_0 : f32,
     v_rest_0 : f32,
     w_rest_0 : f32,
     change_2 : vec2<f32>,
};

fn exact_place_0( triangle_1 : u32,  v_1 : f64,  w_1 : f64) -> Place_0
{
    var place_0 : Place_0;
    place_0.triangle_0 = triangle_1;
    var _S36 : f32 = f32(v_1);
    place_0.v_0 = _S36;
    var _S37 : f32 = f32(w_1);
    place_0.w_0 = _S37;
    place_0.v_rest_0 = f32(v_1 - f64(_S36));
    place_0.w_rest_0 = f32(w_1 - f64(_S37));
    place_0.change_2 = vec2<f32>(0.0f);
    return place_0;
}

fn path_place_0( path_4 : u32,  which_4 : ptr<function, u32>) -> Place_0
{
    var _S38 : u32 = (*which_4) + u32(5);
    (*which_4) = _S38;
    return exact_place_0(path_word_0(path_4, _S38 - u32(5)), f64((bitcast<f32>((path_word_0(path_4, _S38 - u32(4)))))) + f64((bitcast<f32>((path_word_0(path_4, _S38 - u32(2)))))), f64((bitcast<f32>((path_word_0(path_4, _S38 - u32(3)))))) + f64((bitcast<f32>((path_word_0(path_4, _S38 - u32(1)))))));
}

fn change_word_0( at_0 : u32) -> u32
{
    return input_0[launch_0.room_0 + at_0];
}

fn walks_0() -> bool
{
    return (change_word_0(u32(6))) != u32(0);
}

struct Path_0
{
     throughput_0 : Vector_0,
     direction_0 : Vector_0,
     place_1 : Place_0,
     key_0 : vec2<u32>,
     light_0 : Vector_0,
     drift_0 : vec3<f32>,
     walked_0 : vec3<f32>,
     divergence_0 : f32,
};

fn load_0( number_of_path_0 : u32) -> Path_0
{
    var at_1 : u32 = u32(1);
    var path_5 : Path_0;
    var _S39 : Vector_0 = path_changing_0(number_of_path_0, &(at_1));
    path_5.light_0 = _S39;
    var _S40 : Vector_0 = path_changing_0(number_of_path_0, &(at_1));
    path_5.throughput_0 = _S40;
    var _S41 : Vector_0 = path_changing_0(number_of_path_0, &(at_1));
    path_5.direction_0 = _S41;
    var _S42 : vec3<f32> = path_vector_0(number_of_path_0, &(at_1));
    path_5.drift_0 = _S42;
    var _S43 : Place_0 = path_place_0(number_of_path_0, &(at_1));
    path_5.place_1 = _S43;
    path_5.key_0 = vec2<u32>(path_word_0(number_of_path_0, at_1), path_word_0(number_of_path_0, at_1 + u32(1)));
    path_5.walked_0 = vec3<f32>(0.0f);
    path_5.divergence_0 = 0.0f;
    if(walks_0())
    {
        at_1 = u32(29);
        var _S44 : vec3<f32> = path_vector_0(number_of_path_0, &(at_1));
        path_5.walked_0 = _S44;
        path_5.divergence_0 = (bitcast<f32>((path_word_0(number_of_path_0, at_1))));
    }
    return path_5;
}

fn word_0( at_2 : u32) -> u32
{
    return scene_0[at_2];
}

fn triangle_record_0( triangle_2 : u32) -> u32
{
    return word_0(u32(9)) + u32(5) * triangle_2;
}

fn shape_of_0( triangle_3 : u32) -> u32
{
    return word_0(u32(10)) + u32(7) * word_0(triangle_record_0(triangle_3));
}

fn primitive_vector_0( at_3 : u32) -> vec3<f64>
{
    return vec3<f64>(primitives_0[at_3], primitives_0[at_3 + u32(1)], primitives_0[at_3 + u32(2)]);
}

fn position_of_0( place_2 : Place_0) -> vec3<f64>
{
    var at_4 : u32 = u32(9) * place_2.triangle_0;
    var a_1 : vec3<f64> = primitive_vector_0(at_4);
    return a_1 + (primitive_vector_0(at_4 + u32(3)) - a_1) * vec3<f64>((f64(place_2.v_0) + f64(place_2.v_rest_0))) + (primitive_vector_0(at_4 + u32(6)) - a_1) * vec3<f64>((f64(place_2.w_0) + f64(place_2.w_rest_0)));
}

fn cross_of_0( triangle_4 : u32) -> vec3<f32>
{
    var at_5 : u32 = u32(9) * triangle_4;
    var a_2 : vec3<f64> = primitive_vector_0(at_5);
    return cross(vec3<f32>(primitive_vector_0(at_5 + u32(3)) - a_2), vec3<f32>(primitive_vector_0(at_5 + u32(6)) - a_2));
}

fn unit_0( v_2 : vec3<f32>) -> vec3<f32>
{
    return normalize(v_2 / vec3<f32>(max(max(abs(v_2.x), abs(v_2.y)), abs(v_2.z))));
}

fn number_0( at_6 : u32) -> f32
{
    return (bitcast<f32>((scene_0[at_6])));
}

fn vector_at_0( at_7 : u32) -> vec3<f32>
{
    return vec3<f32>(number_0(at_7), number_0(at_7 + u32(1)), number_0(at_7 + u32(2)));
}

struct Surface_0
{
     place_3 : Place_0,
     shape_0 : u32,
     exact_0 : vec3<f64>,
     position_0 : vec3<f32>,
     face_normal_0 : vec3<f32>,
     outward_0 : vec3<f32>,
     is_front_0 : bool,
     position_change_0 : vec3<f32>,
     outward_change_0 : vec3<f32>,
};

fn surface_at_0( place_4 : Place_0,  direction_1 : vec3<f32>) -> Surface_0
{
    var surface_0 : Surface_0;
    surface_0.place_3 = place_4;
    surface_0.shape_0 = shape_of_0(place_4.triangle_0);
    var _S45 : vec3<f64> = position_of_0(place_4);
    surface_0.exact_0 = _S45;
    surface_0.position_0 = vec3<f32>(_S45);
    var _S46 : vec3<f32> = unit_0(cross_of_0(place_4.triangle_0));
    surface_0.face_normal_0 = _S46;
    surface_0.outward_0 = _S46;
    var seen_0 : f32;
    if((dot(_S46, direction_1)) > 0.0f)
    {
        seen_0 = -1.0f;
    }
    else
    {
        seen_0 = 1.0f;
    }
    var normals_0 : u32 = word_0(surface_0.shape_0);
    if(normals_0 != u32(4294967295))
    {
        var record_0 : u32 = triangle_record_0(place_4.triangle_0) + u32(2);
        var a_3 : vec3<f32> = vector_at_0(normals_0 + u32(3) * word_0(record_0));
        var b_1 : vec3<f32> = vector_at_0(normals_0 + u32(3) * word_0(record_0 + u32(1)));
        var c_0 : vec3<f32> = vector_at_0(normals_0 + u32(3) * word_0(record_0 + u32(2)));
        if((dot(a_3 + b_1 + c_0, surface_0.face_normal_0)) < 0.0f)
        {
            seen_0 = - seen_0;
        }
        surface_0.outward_0 = normalize(a_3 + (b_1 - a_3) * vec3<f32>(place_4.v_0) + (c_0 - a_3) * vec3<f32>(place_4.w_0));
    }
    surface_0.is_front_0 = seen_0 > 0.0f;
    var _S47 : vec3<f32> = vec3<f32>(0.0f);
    surface_0.outward_change_0 = _S47;
    surface_0.position_change_0 = _S47;
    return surface_0;
}

fn is_moving_0() -> bool
{
    return (change_word_0(u32(0))) != u32(4294967295);
}

fn motion_of_0( triangle_5 : u32) -> u32
{
    return change_word_0(u32(0)) + u32(21) * triangle_5;
}

fn change_vector_0( at_8 : u32) -> vec3<f32>
{
    return (bitcast<vec3<f32>>((vec3<u32>(change_word_0(at_8), change_word_0(at_8 + u32(1)), change_word_0(at_8 + u32(2))))));
}

fn at_place_0( a_4 : vec3<f32>,  b_2 : vec3<f32>,  c_1 : vec3<f32>,  place_5 : Place_0) -> vec3<f32>
{
    return a_4 + (b_2 - a_4) * vec3<f32>(place_5.v_0) + (c_1 - a_4) * vec3<f32>(place_5.w_0);
}

fn move_place_0( place_6 : ptr<function, Place_0>,  position_change_1 : ptr<function, vec3<f32>>,  direction_2 : vec3<f32>,  drift_1 : vec3<f32>)
{
    (*position_change_1) = drift_1;
    if(!is_moving_0())
    {
        return;
    }
    var at_9 : u32 = motion_of_0((*place_6).triangle_0);
    var corner_0 : u32 = u32(9) * (*place_6).triangle_0;
    var of_material_0 : vec3<f32> = at_place_0(change_vector_0(at_9), change_vector_0(at_9 + u32(3)), change_vector_0(at_9 + u32(6)), (*place_6));
    var a_5 : vec3<f64> = primitive_vector_0(corner_0);
    var _S48 : vec3<f32> = vec3<f32>(primitive_vector_0(corner_0 + u32(3)) - a_5);
    var _S49 : vec3<f32> = vec3<f32>(primitive_vector_0(corner_0 + u32(6)) - a_5);
    var across_0 : vec3<f32> = cross(_S48, _S49);
    var _S50 : f32 = max(max(abs(across_0.x), abs(across_0.y)), abs(across_0.z));
    var normal_0 : vec3<f32> = across_0 / vec3<f32>(_S50);
    var slip_0 : vec3<f32> = drift_1 - of_material_0;
    var slip_1 : vec3<f32> = slip_0 - direction_2 * vec3<f32>((dot(normal_0, slip_0) / dot(normal_0, direction_2)));
    (*position_change_1) = of_material_0 + slip_1;
    (*place_6).change_2 = vec2<f32>(dot(slip_1, cross(_S49, normal_0)), dot(slip_1, cross(normal_0, _S48))) * vec2<f32>((1.0f / (dot(normal_0, normal_0) * _S50)));
    return;
}

fn change_of_unit_0( vector_1 : vec3<f32>,  change_3 : vec3<f32>,  size_0 : f32) -> vec3<f32>
{
    return (change_3 - vector_1 * vec3<f32>(dot(vector_1, change_3))) / vec3<f32>(size_0);
}

fn move_surface_0( surface_1 : ptr<function, Surface_0>,  direction_3 : vec3<f32>,  drift_2 : vec3<f32>)
{
    var _S51 : Place_0 = (*surface_1).place_3;
    var _S52 : vec3<f32> = (*surface_1).position_change_0;
    move_place_0(&(_S51), &(_S52), direction_3, drift_2);
    (*surface_1).place_3 = _S51;
    (*surface_1).position_change_0 = _S52;
    if(!is_moving_0())
    {
        return;
    }
    var place_7 : Place_0 = (*surface_1).place_3;
    var at_10 : u32 = motion_of_0((*surface_1).place_3.triangle_0);
    var normals_1 : u32 = word_0((*surface_1).shape_0);
    if(normals_1 == u32(4294967295))
    {
        var corner_1 : u32 = u32(9) * place_7.triangle_0;
        var a_6 : vec3<f64> = primitive_vector_0(corner_1);
        var _S53 : vec3<f32> = vec3<f32>(primitive_vector_0(corner_1 + u32(3)) - a_6);
        var _S54 : vec3<f32> = vec3<f32>(primitive_vector_0(corner_1 + u32(6)) - a_6);
        var a_change_0 : vec3<f32> = change_vector_0(at_10);
        (*surface_1).outward_change_0 = change_of_unit_0((*surface_1).outward_0, cross(change_vector_0(at_10 + u32(3)) - a_change_0, _S54) + cross(_S53, change_vector_0(at_10 + u32(6)) - a_change_0), length(cross(_S53, _S54)));
        return;
    }
    var record_1 : u32 = triangle_record_0(place_7.triangle_0) + u32(2);
    var a_7 : vec3<f32> = vector_at_0(normals_1 + u32(3) * word_0(record_1));
    var ab_0 : vec3<f32> = vector_at_0(normals_1 + u32(3) * word_0(record_1 + u32(1))) - a_7;
    var ac_0 : vec3<f32> = vector_at_0(normals_1 + u32(3) * word_0(record_1 + u32(2))) - a_7;
    var at_11 : u32 = at_10 + u32(9);
    (*surface_1).outward_change_0 = change_of_unit_0((*surface_1).outward_0, at_place_0(change_vector_0(at_11), change_vector_0(at_11 + u32(3)), change_vector_0(at_11 + u32(6)), place_7) + (ab_0 * vec3<f32>(place_7.change_2.x) + ac_0 * vec3<f32>(place_7.change_2.y)), length(a_7 + ab_0 * vec3<f32>(place_7.v_0) + ac_0 * vec3<f32>(place_7.w_0)));
    return;
}

fn material_of_0( surface_2 : Surface_0) -> u32
{
    var _S55 : u32;
    if(surface_2.is_front_0)
    {
        _S55 = u32(2);
    }
    else
    {
        _S55 = u32(3);
    }
    return word_0(surface_2.shape_0 + _S55);
}

fn edge_word_0( at_12 : u32) -> u32
{
    return change_word_0(change_word_0(u32(3)) + at_12);
}

struct Numbers_0
{
     diffuse_reflectance_0 : vec3<f32>,
     specular_reflectance_0 : vec3<f32>,
     eta_0 : vec3<f32>,
     k_0 : vec3<f32>,
     alpha_0 : vec2<f32>,
};

fn no_numbers_0() -> Numbers_0
{
    var numbers_0 : Numbers_0;
    var _S56 : vec3<f32> = vec3<f32>(0.0f);
    numbers_0.k_0 = _S56;
    numbers_0.eta_0 = _S56;
    numbers_0.specular_reflectance_0 = _S56;
    numbers_0.diffuse_reflectance_0 = _S56;
    numbers_0.alpha_0 = vec2<f32>(0.0f);
    return numbers_0;
}

struct Lookup_0
{
     count_0 : u32,
     texels_0 : vec4<u32>,
     weights_0 : vec4<f32>,
     by_first_0 : vec4<f32>,
     by_second_0 : vec4<f32>,
};

fn one_texel_0( texel_0 : u32) -> Lookup_0
{
    var lookup_0 : Lookup_0;
    lookup_0.count_0 = u32(1);
    lookup_0.texels_0 = vec4<u32>(texel_0, u32(0), u32(0), u32(0));
    lookup_0.weights_0 = vec4<f32>(1.0f, 0.0f, 0.0f, 0.0f);
    var _S57 : vec4<f32> = vec4<f32>(0.0f);
    lookup_0.by_second_0 = _S57;
    lookup_0.by_first_0 = _S57;
    return lookup_0;
}

struct Corners2_0
{
     a_8 : vec2<f64>,
     b_3 : vec2<f64>,
     c_2 : vec2<f64>,
};

fn Corners2_x24init_0( a_9 : vec2<f64>,  b_4 : vec2<f64>,  c_3 : vec2<f64>) -> Corners2_0
{
    var _S58 : Corners2_0;
    _S58.a_8 = a_9;
    _S58.b_3 = b_4;
    _S58.c_2 = c_3;
    return _S58;
}

fn precise_0( at_13 : u32) -> f64
{
    return f64(number_0(at_13)) + f64(number_0(at_13 + u32(1)));
}

fn uvs_of_0( triangle_6 : u32) -> Corners2_0
{
    var uvs_0 : Corners2_0 = Corners2_x24init_0(vec2<f64>(0.0lf, 0.0lf), vec2<f64>(1.0lf, 0.0lf), vec2<f64>(0.0lf, 1.0lf));
    var uvs_at_0 : u32 = word_0(shape_of_0(triangle_6) + u32(1));
    if(uvs_at_0 == u32(4294967295))
    {
        return uvs_0;
    }
    var at_14 : u32 = uvs_at_0 + u32(12) * word_0(triangle_record_0(triangle_6) + u32(1));
    uvs_0.a_8 = vec2<f64>(precise_0(at_14), precise_0(at_14 + u32(2)));
    uvs_0.b_3 = vec2<f64>(precise_0(at_14 + u32(4)), precise_0(at_14 + u32(6)));
    uvs_0.c_2 = vec2<f64>(precise_0(at_14 + u32(8)), precise_0(at_14 + u32(10)));
    return uvs_0;
}

fn row_at_0( at_15 : u32) -> vec3<f64>
{
    return vec3<f64>(precise_0(at_15), precise_0(at_15 + u32(2)), precise_0(at_15 + u32(4)));
}

fn floor_of_0( x_0 : f64) -> i32
{
    return i32(clamp(f32(floor(x_0)), -1.0e+09f, 1.0e+09f));
}

fn wrapped_0( i_0 : i32,  n_0 : i32,  wrap_0 : u32) -> u32
{
    if(wrap_0 == u32(2))
    {
        return u32(clamp(i_0, i32(0), n_0 - i32(1)));
    }
    var period_0 : i32;
    if(wrap_0 == u32(1))
    {
        period_0 = i32(2) * n_0;
    }
    else
    {
        period_0 = n_0;
    }
    var inside_0 : i32 = i_0 % period_0;
    var inside_1 : i32;
    if(inside_0 < i32(0))
    {
        inside_1 = inside_0 + period_0;
    }
    else
    {
        inside_1 = inside_0;
    }
    if(inside_1 < n_0)
    {
        period_0 = inside_1;
    }
    else
    {
        period_0 = i32(2) * n_0 - i32(1) - inside_1;
    }
    return u32(period_0);
}

struct Point_0
{
     value_3 : vec2<f64>,
     by_first_1 : vec2<f32>,
     by_second_1 : vec2<f32>,
};

fn between_0( texels_1 : vec4<u32>,  place_8 : Point_0) -> Lookup_0
{
    var _S59 : vec2<f32> = vec2<f32>(place_8.value_3 - floor(place_8.value_3));
    var back_0 : vec2<f32> = vec2<f32>(1.0f) - _S59;
    var lookup_1 : Lookup_0;
    lookup_1.count_0 = u32(4);
    lookup_1.texels_0 = texels_1;
    var _S60 : f32 = back_0.x;
    var _S61 : f32 = back_0.y;
    var _S62 : f32 = _S59.x;
    var _S63 : f32 = _S59.y;
    lookup_1.weights_0 = vec4<f32>(_S60 * _S61, _S62 * _S61, _S60 * _S63, _S62 * _S63);
    var by_x_0 : vec4<f32> = vec4<f32>(- _S61, _S61, - _S63, _S63);
    var by_y_0 : vec4<f32> = vec4<f32>(- _S60, - _S62, _S60, _S62);
    lookup_1.by_first_0 = by_x_0 * vec4<f32>(place_8.by_first_1.x) + by_y_0 * vec4<f32>(place_8.by_first_1.y);
    lookup_1.by_second_0 = by_x_0 * vec4<f32>(place_8.by_second_1.x) + by_y_0 * vec4<f32>(place_8.by_second_1.y);
    return lookup_1;
}

fn in_bitmap_0( texture_0 : u32,  uv_0 : Point_0) -> Lookup_0
{
    var width_0 : i32 = i32(word_0(texture_0 + u32(2)));
    var height_0 : i32 = i32(word_0(texture_0 + u32(3)));
    var wrap_1 : u32 = word_0(texture_0 + u32(5));
    var size_1 : vec2<f32> = vec2<f32>(f32(width_0), f32(height_0));
    var place_9 : vec2<f64> = uv_0.value_3 * vec2<f64>(size_1);
    if((word_0(texture_0 + u32(4))) == u32(0))
    {
        var row_0 : u32 = wrapped_0(floor_of_0(place_9.y), height_0, wrap_1);
        var _S64 : u32 = row_0 * u32(width_0);
        var _S65 : u32 = wrapped_0(floor_of_0(place_9.x), width_0, wrap_1);
        return one_texel_0(_S64 + _S65);
    }
    var centred_0 : Point_0;
    var _S66 : vec2<f64> = place_9 - vec2<f64>(0.5lf);
    centred_0.value_3 = _S66;
    centred_0.by_first_1 = uv_0.by_first_1 * size_1;
    centred_0.by_second_1 = uv_0.by_second_1 * size_1;
    var x_1 : i32 = floor_of_0(_S66.x);
    var y_0 : i32 = floor_of_0(_S66.y);
    var _S67 : u32 = wrapped_0(y_0, height_0, wrap_1);
    var _S68 : u32 = u32(width_0);
    var first_1 : u32 = _S67 * _S68;
    var _S69 : u32 = wrapped_0(y_0 + i32(1), height_0, wrap_1);
    var second_0 : u32 = _S69 * _S68;
    var left_0 : u32 = wrapped_0(x_1, width_0, wrap_1);
    var right_0 : u32 = wrapped_0(x_1 + i32(1), width_0, wrap_1);
    return between_0(vec4<u32>(first_1 + left_0, first_1 + right_0, second_0 + left_0, second_0 + right_0), centred_0);
}

fn lookup_at_0( texture_1 : u32,  place_10 : Place_0) -> Lookup_0
{
    var kind_0 : u32 = word_0(texture_1);
    if(kind_0 == u32(0))
    {
        return one_texel_0(u32(0));
    }
    var record_2 : u32 = triangle_record_0(place_10.triangle_0) + u32(1);
    if(kind_0 == u32(4))
    {
        return one_texel_0(word_0(record_2));
    }
    if(kind_0 == u32(3))
    {
        var lookup_2 : Lookup_0;
        lookup_2.count_0 = u32(3);
        lookup_2.texels_0 = vec4<u32>(word_0(record_2 + u32(1)), word_0(record_2 + u32(2)), word_0(record_2 + u32(3)), u32(0));
        lookup_2.weights_0 = vec4<f32>(1.0f - place_10.v_0 - place_10.w_0, place_10.v_0, place_10.w_0, 0.0f);
        lookup_2.by_first_0 = vec4<f32>(-1.0f, 1.0f, 0.0f, 0.0f);
        lookup_2.by_second_0 = vec4<f32>(-1.0f, 0.0f, 1.0f, 0.0f);
        return lookup_2;
    }
    var uvs_1 : Corners2_0 = uvs_of_0(place_10.triangle_0);
    var by_v_0 : vec2<f64> = uvs_1.b_3 - uvs_1.a_8;
    var by_w_0 : vec2<f64> = uvs_1.c_2 - uvs_1.a_8;
    var _S70 : u32 = texture_1 + u32(6);
    var to_u_0 : vec3<f64> = row_at_0(_S70);
    var to_v_0 : vec3<f64> = row_at_0(_S70 + u32(6));
    var uv_1 : Point_0;
    var _S71 : vec3<f64> = vec3<f64>(uvs_1.a_8 + by_v_0 * vec2<f64>((f64(place_10.v_0) + f64(place_10.v_rest_0))) + by_w_0 * vec2<f64>((f64(place_10.w_0) + f64(place_10.w_rest_0))), 1.0lf);
    uv_1.value_3 = vec2<f64>(dot(_S71, to_u_0), dot(_S71, to_v_0));
    var _S72 : vec2<f64> = to_u_0.xy;
    var _S73 : vec2<f64> = to_v_0.xy;
    uv_1.by_first_1 = vec2<f32>(vec2<f64>(dot(by_v_0, _S72), dot(by_v_0, _S73)));
    uv_1.by_second_1 = vec2<f32>(vec2<f64>(dot(by_w_0, _S72), dot(by_w_0, _S73)));
    if(kind_0 == u32(1))
    {
        var _S74 : Lookup_0 = in_bitmap_0(texture_1, uv_1);
        return _S74;
    }
    var half_of_period_0 : vec2<f64> = uv_1.value_3 - floor(uv_1.value_3);
    var _S75 : i32;
    if(((half_of_period_0.x) > 0.5lf) != ((half_of_period_0.y) > 0.5lf))
    {
        _S75 = i32(1);
    }
    else
    {
        _S75 = i32(0);
    }
    return one_texel_0(u32(_S75));
}

fn weighted_texels_0( texture_2 : u32,  lookup_3 : Lookup_0,  weights_1 : vec4<f32>) -> vec3<f32>
{
    var _S76 : u32 = word_0(texture_2 + u32(1));
    var _S77 : u32 = texture_2 + u32(19);
    var _S78 : vec3<f32> = vec3<f32>(0.0f);
    var k_1 : u32 = u32(0);
    var value_4 : vec3<f32> = _S78;
    for(;;)
    {
        if(k_1 < (lookup_3.count_0))
        {
        }
        else
        {
            break;
        }
        var at_16 : u32 = _S77 + _S76 * lookup_3.texels_0[k_1];
        var _S79 : vec3<f32>;
        if(_S76 == u32(1))
        {
            _S79 = vec3<f32>(number_0(at_16));
        }
        else
        {
            _S79 = vector_at_0(at_16);
        }
        var value_5 : vec3<f32> = value_4 + _S79 * vec3<f32>(weights_1[k_1]);
        k_1 = k_1 + u32(1);
        value_4 = value_5;
    }
    return value_4;
}

fn numbers_of_0( texture_3 : u32) -> u32
{
    return change_word_0(u32(7) + word_0(texture_3 + u32(18)));
}

fn looked_up_0( texture_4 : u32,  lookup_4 : Lookup_0,  place_change_0 : vec2<f32>) -> Vector_0
{
    var value_6 : vec3<f32> = weighted_texels_0(texture_4, lookup_4, lookup_4.weights_0);
    var change_4 : vec3<f32> = weighted_texels_0(texture_4, lookup_4, lookup_4.by_first_0 * vec4<f32>(place_change_0.x) + lookup_4.by_second_0 * vec4<f32>(place_change_0.y));
    var first_2 : u32 = numbers_of_0(texture_4);
    if(first_2 == u32(4294967295))
    {
        return changing_0(value_6, change_4);
    }
    var _S80 : bool = (word_0(texture_4 + u32(1))) == u32(1);
    var k_2 : u32 = u32(0);
    var change_5 : vec3<f32> = change_4;
    for(;;)
    {
        if(k_2 < (lookup_4.count_0))
        {
        }
        else
        {
            break;
        }
        var _S81 : i32;
        if(_S80)
        {
            _S81 = i32(1);
        }
        else
        {
            _S81 = i32(3);
        }
        var at_17 : u32 = first_2 + u32(_S81) * lookup_4.texels_0[k_2];
        var of_texel_0 : vec3<f32>;
        if(_S80)
        {
            of_texel_0 = (bitcast<vec3<f32>>((vec3<u32>(change_word_0(at_17)))));
        }
        else
        {
            of_texel_0 = change_vector_0(at_17);
        }
        var change_6 : vec3<f32> = change_5 + of_texel_0 * vec3<f32>(lookup_4.weights_0[k_2]);
        k_2 = k_2 + u32(1);
        change_5 = change_6;
    }
    return changing_0(value_6, change_5);
}

fn shown_0( texture_5 : u32,  place_11 : Place_0) -> Vector_0
{
    var _S82 : Lookup_0 = lookup_at_0(texture_5, place_11);
    return looked_up_0(texture_5, _S82, place_11.change_2);
}

fn value_of_0( vector_2 : Vector_0) -> vec3<f32>
{
    return vector_2.value_0;
}

fn luminance_0( colour_0 : vec3<f32>) -> f32
{
    return dot(colour_0, vec3<f32>(0.21267099678516388f, 0.71516001224517822f, 0.07216899842023849f));
}

fn set_slot_0( numbers_1 : ptr<function, Numbers_0>,  slot_0 : u32,  value_7 : vec3<f32>)
{
    switch(slot_0)
    {
    case u32(0):
        {
            (*numbers_1).diffuse_reflectance_0 = value_7;
            break;
        }
    case u32(1):
        {
            (*numbers_1).specular_reflectance_0 = value_7;
            break;
        }
    case u32(2):
        {
            (*numbers_1).eta_0 = value_7;
            break;
        }
    case u32(3):
        {
            (*numbers_1).k_0 = value_7;
            break;
        }
    case u32(4):
        {
            (*numbers_1).alpha_0[i32(0)] = luminance_0(value_7);
            break;
        }
    default :
        {
            (*numbers_1).alpha_0[i32(1)] = luminance_0(value_7);
            break;
        }
    }
    return;
}

fn change_of_0( vector_3 : Vector_0) -> vec3<f32>
{
    return vector_3.change_0;
}

struct Lobe_0
{
     record_3 : u32,
     kind_1 : u32,
     distribution_0 : u32,
     numbers_2 : Numbers_0,
     changes_0 : Numbers_0,
};

fn lobe_at_0( record_4 : u32,  place_12 : Place_0) -> Lobe_0
{
    var lobe_0 : Lobe_0;
    lobe_0.record_3 = record_4;
    var is_black_0 : bool = record_4 == u32(4294967295);
    var _S83 : u32;
    if(is_black_0)
    {
        _S83 = u32(0);
    }
    else
    {
        _S83 = word_0(record_4);
    }
    lobe_0.kind_1 = _S83;
    if(is_black_0)
    {
        _S83 = u32(1);
    }
    else
    {
        _S83 = word_0(record_4 + u32(1));
    }
    lobe_0.distribution_0 = _S83;
    var _S84 : Numbers_0 = no_numbers_0();
    lobe_0.numbers_2 = _S84;
    lobe_0.changes_0 = _S84;
    if(is_black_0)
    {
        _S83 = u32(0);
    }
    else
    {
        _S83 = word_0(record_4 + u32(4));
    }
    var slot_1 : u32 = u32(0);
    for(;;)
    {
        if(slot_1 < _S83)
        {
        }
        else
        {
            break;
        }
        var texture_6 : u32 = word_0(record_4 + u32(5) + slot_1);
        if(texture_6 == u32(4294967295))
        {
            slot_1 = slot_1 + u32(1);
            continue;
        }
        var colour_1 : Vector_0 = shown_0(texture_6, place_12);
        var _S85 : vec3<f32> = value_of_0(colour_1);
        var _S86 : Numbers_0 = lobe_0.numbers_2;
        set_slot_0(&(_S86), slot_1, _S85);
        lobe_0.numbers_2 = _S86;
        var _S87 : vec3<f32> = change_of_0(colour_1);
        var _S88 : Numbers_0 = lobe_0.changes_0;
        set_slot_0(&(_S88), slot_1, _S87);
        lobe_0.changes_0 = _S88;
        slot_1 = slot_1 + u32(1);
    }
    return lobe_0;
}

fn tangent_at_0( surface_3 : Surface_0) -> vec3<f32>
{
    var tangents_0 : u32 = word_0(surface_3.shape_0 + u32(5));
    if(tangents_0 == u32(4294967295))
    {
        return vec3<f32>(0.0f);
    }
    var tangent_0 : vec3<f32> = vector_at_0(tangents_0 + u32(3) * word_0(triangle_record_0(surface_3.place_3.triangle_0) + u32(1)));
    var across_1 : vec3<f32> = cross(tangent_0, surface_3.outward_0);
    var _S89 : vec3<f32>;
    if((dot(across_1, across_1)) > 0.0f)
    {
        _S89 = tangent_0;
    }
    else
    {
        _S89 = vec3<f32>(0.0f);
    }
    return _S89;
}

struct Axes_0
{
     s_0 : vec3<f32>,
     t_0 : vec3<f32>,
     n_1 : vec3<f32>,
};

struct DiffPair_Axes_0
{
     primal_0 : Axes_0,
     differential_0 : Axes_0,
};

fn s_fwd_axes_along_0( dpn_0 : DiffPair_vectorx3Cfloatx2C3x3E_0,  dptangent_0 : DiffPair_vectorx3Cfloatx2C3x3E_0,  is_front_1 : bool) -> DiffPair_Axes_0
{
    var _S90 : vec3<f32>;
    var _S91 : vec3<f32>;
    if(is_front_1)
    {
        _S90 = dpn_0.primal_0;
        _S91 = dpn_0.differential_0;
    }
    else
    {
        var _S92 : vec3<f32> = (vec3<f32>(0) - dpn_0.differential_0);
        _S90 = (vec3<f32>(0) - dpn_0.primal_0);
        _S91 = _S92;
    }
    var _S93 : DiffPair_vectorx3Cfloatx2C3x3E_0 = DiffPair_vectorx3Cfloatx2C3x3E_0( dpn_0.primal_0, dpn_0.differential_0 );
    var _S94 : DiffPair_vectorx3Cfloatx2C3x3E_0 = DiffPair_vectorx3Cfloatx2C3x3E_0( dptangent_0.primal_0, dptangent_0.differential_0 );
    var _S95 : DiffPair_float_0 = _d_dot_0(_S93, _S94);
    var _S96 : vec3<f32> = vec3<f32>(_S95.primal_0);
    var _S97 : DiffPair_vectorx3Cfloatx2C3x3E_0 = DiffPair_vectorx3Cfloatx2C3x3E_0( dptangent_0.primal_0 - dpn_0.primal_0 * _S96, dptangent_0.differential_0 - (dpn_0.differential_0 * _S96 + vec3<f32>(_S95.differential_0) * dpn_0.primal_0) );
    var _S98 : DiffPair_vectorx3Cfloatx2C3x3E_0 = s_fwd_normalize_impl_0(_S97);
    var _S99 : DiffPair_vectorx3Cfloatx2C3x3E_0 = DiffPair_vectorx3Cfloatx2C3x3E_0( _S98.primal_0, _S98.differential_0 );
    var _S100 : DiffPair_vectorx3Cfloatx2C3x3E_0 = _d_cross_0(_S93, _S99);
    var _S101 : Axes_0 = Axes_0( _S98.primal_0, _S100.primal_0, _S90 );
    var _S102 : Axes_0 = Axes_0( _S98.differential_0, _S100.differential_0, _S91 );
    var _S103 : DiffPair_Axes_0 = DiffPair_Axes_0( _S101, _S102 );
    return _S103;
}

fn axes_around_0( n_2 : vec3<f32>,  is_front_2 : bool) -> Axes_0
{
    var axes_0 : Axes_0;
    var _S104 : vec3<f32>;
    if(is_front_2)
    {
        _S104 = n_2;
    }
    else
    {
        _S104 = (vec3<f32>(0) - n_2);
    }
    axes_0.n_1 = _S104;
    var _S105 : f32 = n_2.z;
    var sign_0 : f32;
    if(_S105 < -0.00000999999974738f)
    {
        sign_0 = -1.0f;
    }
    else
    {
        sign_0 = 1.0f;
    }
    var a_10 : f32 = -1.0f / (sign_0 + _S105);
    var _S106 : f32 = n_2.x;
    var _S107 : f32 = n_2.y;
    var b_5 : f32 = _S106 * _S107 * a_10;
    axes_0.s_0 = vec3<f32>(1.0f + sign_0 * _S106 * _S106 * a_10, sign_0 * b_5, - sign_0 * _S106);
    axes_0.t_0 = vec3<f32>(b_5, sign_0 + _S107 * _S107 * a_10, - _S107);
    return axes_0;
}

fn s_fwd_axes_around_0( dpn_1 : DiffPair_vectorx3Cfloatx2C3x3E_0,  is_front_3 : bool) -> DiffPair_Axes_0
{
    var _S108 : vec3<f32>;
    var _S109 : vec3<f32>;
    if(is_front_3)
    {
        _S108 = dpn_1.primal_0;
        _S109 = dpn_1.differential_0;
    }
    else
    {
        var _S110 : vec3<f32> = (vec3<f32>(0) - dpn_1.differential_0);
        _S108 = (vec3<f32>(0) - dpn_1.primal_0);
        _S109 = _S110;
    }
    var _S111 : f32 = dpn_1.primal_0.z;
    var _S112 : f32 = dpn_1.differential_0.z;
    var sign_1 : f32;
    if(_S111 < -0.00000999999974738f)
    {
        sign_1 = -1.0f;
    }
    else
    {
        sign_1 = 1.0f;
    }
    var _S113 : f32 = sign_1 + _S111;
    var a_11 : f32 = -1.0f / _S113;
    var s_diff_a_0 : f32 = (0.0f - -1.0f * _S112) / (_S113 * _S113);
    var _S114 : f32 = dpn_1.primal_0.x;
    var _S115 : f32 = dpn_1.differential_0.x;
    var _S116 : f32 = dpn_1.primal_0.y;
    var _S117 : f32 = dpn_1.differential_0.y;
    var _S118 : f32 = _S114 * _S116;
    var b_6 : f32 = _S118 * a_11;
    var s_diff_b_0 : f32 = (_S115 * _S116 + _S117 * _S114) * a_11 + s_diff_a_0 * _S118;
    var _S119 : f32 = sign_1 * _S114;
    var _S120 : f32 = _S119 * _S114;
    var _S121 : f32 = - sign_1;
    var _S122 : f32 = _S116 * _S116;
    var _S123 : f32 = _S117 * _S116;
    var _S124 : Axes_0 = Axes_0( vec3<f32>(1.0f + _S120 * a_11, sign_1 * b_6, _S121 * _S114), vec3<f32>(b_6, sign_1 + _S122 * a_11, - _S116), _S108 );
    var _S125 : Axes_0 = Axes_0( vec3<f32>((_S115 * sign_1 * _S114 + _S115 * _S119) * a_11 + s_diff_a_0 * _S120, s_diff_b_0 * sign_1, _S115 * _S121), vec3<f32>(s_diff_b_0, (_S123 + _S123) * a_11 + s_diff_a_0 * _S122, - _S117), _S109 );
    var _S126 : DiffPair_Axes_0 = DiffPair_Axes_0( _S124, _S125 );
    return _S126;
}

fn s_fwd_to_local_0( dpaxes_0 : DiffPair_Axes_0,  dpv_0 : DiffPair_vectorx3Cfloatx2C3x3E_0) -> DiffPair_vectorx3Cfloatx2C3x3E_0
{
    var _S127 : DiffPair_vectorx3Cfloatx2C3x3E_0 = DiffPair_vectorx3Cfloatx2C3x3E_0( dpaxes_0.primal_0.s_0, dpaxes_0.differential_0.s_0 );
    var _S128 : DiffPair_vectorx3Cfloatx2C3x3E_0 = DiffPair_vectorx3Cfloatx2C3x3E_0( dpv_0.primal_0, dpv_0.differential_0 );
    var _S129 : DiffPair_float_0 = _d_dot_0(_S127, _S128);
    var _S130 : DiffPair_vectorx3Cfloatx2C3x3E_0 = DiffPair_vectorx3Cfloatx2C3x3E_0( dpaxes_0.primal_0.t_0, dpaxes_0.differential_0.t_0 );
    var _S131 : DiffPair_float_0 = _d_dot_0(_S130, _S128);
    var _S132 : DiffPair_vectorx3Cfloatx2C3x3E_0 = DiffPair_vectorx3Cfloatx2C3x3E_0( dpaxes_0.primal_0.n_1, dpaxes_0.differential_0.n_1 );
    var _S133 : DiffPair_float_0 = _d_dot_0(_S132, _S128);
    var _S134 : DiffPair_vectorx3Cfloatx2C3x3E_0 = DiffPair_vectorx3Cfloatx2C3x3E_0( vec3<f32>(_S129.primal_0, _S131.primal_0, _S133.primal_0), vec3<f32>(_S129.differential_0, _S131.differential_0, _S133.differential_0) );
    return _S134;
}

fn s_fwd_towards_viewer_0( dpaxes_1 : DiffPair_Axes_0,  dpdirection_0 : DiffPair_vectorx3Cfloatx2C3x3E_0) -> DiffPair_vectorx3Cfloatx2C3x3E_0
{
    var _S135 : DiffPair_Axes_0 = DiffPair_Axes_0( dpaxes_1.primal_0, dpaxes_1.differential_0 );
    var _S136 : DiffPair_vectorx3Cfloatx2C3x3E_0 = DiffPair_vectorx3Cfloatx2C3x3E_0( dpdirection_0.primal_0, dpdirection_0.differential_0 );
    var _S137 : DiffPair_vectorx3Cfloatx2C3x3E_0 = s_fwd_to_local_0(_S135, _S136);
    var wi_0 : vec3<f32> = (vec3<f32>(0) - _S137.primal_0);
    var s_diff_wi_0 : vec3<f32> = (vec3<f32>(0) - _S137.differential_0);
    var _S138 : DiffPair_float_0 = DiffPair_float_0( wi_0.z, s_diff_wi_0.z );
    var _S139 : DiffPair_float_0 = _d_abs_0(_S138);
    var _S140 : DiffPair_float_0 = DiffPair_float_0( _S139.primal_0, _S139.differential_0 );
    var _S141 : DiffPair_float_0 = DiffPair_float_0( 9.999999960041972e-13f, 0.0f );
    var _S142 : DiffPair_float_0 = _d_max_0(_S140, _S141);
    var _S143 : DiffPair_vectorx3Cfloatx2C3x3E_0 = DiffPair_vectorx3Cfloatx2C3x3E_0( vec3<f32>(wi_0.x, wi_0.y, _S142.primal_0), vec3<f32>(s_diff_wi_0.x, s_diff_wi_0.y, _S142.differential_0) );
    return _S143;
}

struct Vertex_0
{
     surface_4 : Surface_0,
     axes_1 : Axes_0,
     lobe_1 : Lobe_0,
     wi_1 : Vector_0,
     axes_change_0 : Axes_0,
};

fn vertex_at_0( surface_5 : Surface_0,  material_0 : u32,  direction_4 : Vector_0) -> Vertex_0
{
    var vertex_0 : Vertex_0;
    vertex_0.surface_4 = surface_5;
    var _S144 : Lobe_0 = lobe_at_0(material_0, surface_5.place_3);
    vertex_0.lobe_1 = _S144;
    var tangent_1 : vec3<f32> = tangent_at_0(surface_5);
    var _S145 : vec3<f32> = vec3<f32>(0.0f);
    var tangent_change_0 : vec3<f32>;
    if(is_moving_0())
    {
        tangent_change_0 = change_vector_0(motion_of_0(surface_5.place_3.triangle_0) + u32(18));
    }
    else
    {
        tangent_change_0 = _S145;
    }
    var _S146 : DiffPair_vectorx3Cfloatx2C3x3E_0 = DiffPair_vectorx3Cfloatx2C3x3E_0( surface_5.outward_0, surface_5.outward_change_0 );
    var axes_2 : DiffPair_Axes_0;
    if((any((tangent_1 != _S145))))
    {
        var _S147 : DiffPair_vectorx3Cfloatx2C3x3E_0 = DiffPair_vectorx3Cfloatx2C3x3E_0( tangent_1, tangent_change_0 );
        axes_2 = s_fwd_axes_along_0(_S146, _S147, surface_5.is_front_0);
    }
    else
    {
        axes_2 = s_fwd_axes_around_0(_S146, surface_5.is_front_0);
    }
    vertex_0.axes_1 = axes_2.primal_0;
    vertex_0.axes_change_0 = axes_2.differential_0;
    var _S148 : DiffPair_vectorx3Cfloatx2C3x3E_0 = DiffPair_vectorx3Cfloatx2C3x3E_0( value_of_0(direction_4), change_of_0(direction_4) );
    var _S149 : DiffPair_vectorx3Cfloatx2C3x3E_0 = s_fwd_towards_viewer_0(axes_2, _S148);
    vertex_0.wi_1 = changing_0(_S149.primal_0, _S149.differential_0);
    return vertex_0;
}

fn vertex_numbers_0( depth_1 : u32) -> u32
{
    return word_0(u32(7)) + depth_1 * (u32(3) * word_0(u32(2)) + u32(3) * word_0(u32(3)) + u32(1));
}

fn first_material_number_0( depth_2 : u32) -> u32
{
    return vertex_numbers_0(depth_2) + u32(3) * word_0(u32(2));
}

fn product_0( a_12 : u32,  b_7 : u32) -> vec2<u32>
{
    var a0_0 : u32 = (a_12 & (u32(65535)));
    var a1_0 : u32 = (a_12 >> (u32(16)));
    var b0_0 : u32 = (b_7 & (u32(65535)));
    var b1_0 : u32 = (b_7 >> (u32(16)));
    var low_0 : u32 = a0_0 * b0_0;
    var middle_0 : u32 = a1_0 * b0_0 + ((low_0 >> (u32(16))));
    var rest_0 : u32 = ((middle_0 & (u32(65535)))) + a0_0 * b1_0;
    return vec2<u32>((((rest_0 << (u32(16)))) | (((low_0 & (u32(65535)))))), a1_0 * b1_0 + ((middle_0 >> (u32(16)))) + ((rest_0 >> (u32(16)))));
}

fn times_0( a_13 : vec2<u32>,  b_8 : vec2<u32>) -> vec2<u32>
{
    var _S150 : u32 = a_13.x;
    var _S151 : u32 = b_8.x;
    var low_1 : vec2<u32> = product_0(_S150, _S151);
    return vec2<u32>(low_1.x, low_1.y + _S150 * b_8.y + a_13.y * _S151);
}

fn plus_0( a_14 : vec2<u32>,  b_9 : vec2<u32>) -> vec2<u32>
{
    var _S152 : u32 = a_14.x;
    var low_2 : u32 = _S152 + b_9.x;
    var _S153 : u32 = a_14.y + b_9.y;
    var _S154 : i32;
    if(low_2 < _S152)
    {
        _S154 = i32(1);
    }
    else
    {
        _S154 = i32(0);
    }
    return vec2<u32>(low_2, _S153 + u32(_S154));
}

fn shifted_xor_0( x_2 : vec2<u32>,  by_0 : u32) -> vec2<u32>
{
    var _S155 : u32 = x_2.y;
    return (x_2 ^ (vec2<u32>(((((x_2.x) >> (by_0))) | (((_S155 << ((u32(32) - by_0)))))), (_S155 >> (by_0)))));
}

fn mix_0( x_3 : vec2<u32>) -> vec2<u32>
{
    return shifted_xor_0(times_0(shifted_xor_0(times_0(shifted_xor_0(x_3, u32(30)), vec2<u32>(u32(484763065), u32(3210233709))), u32(27)), vec2<u32>(u32(321982955), u32(2496678331))), u32(31));
}

fn random_bits_0( key_1 : vec2<u32>,  dimension_0 : u32) -> vec2<u32>
{
    return mix_0(plus_0(key_1, times_0(vec2<u32>(dimension_0 + u32(1), u32(0)), vec2<u32>(u32(2135587861), u32(2654435769)))));
}

fn random_0( key_2 : vec2<u32>,  dimension_1 : u32) -> f32
{
    return f32(((random_bits_0(key_2, dimension_1).y) >> (u32(8)))) * 5.9604644775390625e-08f;
}

fn random_pair_0( key_3 : vec2<u32>,  dimension_2 : u32) -> vec2<f32>
{
    return vec2<f32>(random_0(key_3, dimension_2), random_0(key_3, dimension_2 + u32(1)));
}

fn coat_eta_0( numbers_3 : Numbers_0) -> f32
{
    return luminance_0(numbers_3.eta_0) / luminance_0(numbers_3.k_0);
}

fn fresnel_dielectric_0( cosine_0 : f32,  eta_1 : f32) -> f32
{
    var eta2_0 : f32 = eta_1 * eta_1;
    var cos2_0 : f32 = cosine_0 * cosine_0;
    var denser_0 : f32 = (eta_1 - 1.0f) * (eta_1 + 1.0f);
    var squared_0 : f32 = denser_0 + cos2_0;
    if(squared_0 <= 0.0f)
    {
        return 1.0f;
    }
    var refracted_0 : f32 = sqrt(squared_0);
    var s_sum_0 : f32 = cosine_0 + refracted_0;
    var p_sum_0 : f32 = eta2_0 * cosine_0 + refracted_0;
    var senkrecht_0 : f32 = denser_0 / (s_sum_0 * s_sum_0);
    var parallel_0 : f32 = denser_0 * ((eta2_0 + 1.0f) * cos2_0 - 1.0f) / (p_sum_0 * p_sum_0);
    return 0.5f * (senkrecht_0 * senkrecht_0 + parallel_0 * parallel_0);
}

fn transmittance_0( lobe_2 : Lobe_0,  eta_2 : f32,  cosine_1 : f32) -> f32
{
    if((lobe_2.kind_1) == u32(3))
    {
        return 1.0f - fresnel_dielectric_0(cosine_1, eta_2);
    }
    var place_13 : f32 = cosine_1 * 63.0f;
    var _S156 : u32 = min(u32(place_13), u32(62));
    var at_18 : u32 = word_0(lobe_2.record_3 + u32(3)) + _S156;
    var here_0 : f32 = number_0(at_18);
    return here_0 + (number_0(at_18 + u32(1)) - here_0) * (place_13 - f32(_S156));
}

fn choice_weight_0( colour_2 : vec3<f32>) -> f32
{
    return max((colour_2.x + colour_2.y + colour_2.z) / 3.0f, 0.05000000074505806f);
}

fn base_probability_0( numbers_4 : Numbers_0,  enters_0 : f32) -> f32
{
    var of_base_0 : f32 = enters_0 * choice_weight_0(numbers_4.diffuse_reflectance_0);
    return of_base_0 / (of_base_0 + (1.0f - enters_0) * choice_weight_0(numbers_4.specular_reflectance_0));
}

fn sine_cosine_0( angle_0 : f32) -> vec2<f32>
{
    var quarters_0 : f32 = floor(angle_0 * 0.63661974668502808f + 0.5f);
    var x_4 : f32 = angle_0 - quarters_0 * 1.5703125f - quarters_0 * 0.00048375129699707f - quarters_0 * 7.54979012640433211e-08f;
    var z_0 : f32 = x_4 * x_4;
    var sine_0 : f32 = ((-0.00019515295571182f * z_0 + 0.00833216123282909f) * z_0 - 0.16666655242443085f) * z_0 * x_4 + x_4;
    var cosine_2 : f32 = ((0.00002443315679557f * z_0 - 0.00138873164542019f) * z_0 + 0.04166664555668831f) * z_0 * z_0 - 0.5f * z_0 + 1.0f;
    var quarter_0 : i32 = (i32(quarters_0) & (i32(3)));
    var turned_0 : vec2<f32>;
    if(((quarter_0 & (i32(1)))) != i32(0))
    {
        turned_0 = vec2<f32>(cosine_2, - sine_0);
    }
    else
    {
        turned_0 = vec2<f32>(sine_0, cosine_2);
    }
    if(quarter_0 < i32(2))
    {
    }
    else
    {
        turned_0 = (vec2<f32>(0) - turned_0);
    }
    return turned_0;
}

fn sample_cosine_0( u_0 : vec2<f32>) -> vec3<f32>
{
    var _S157 : f32 = u_0.x;
    var turn_0 : vec2<f32> = sine_cosine_0(6.28318548202514648f * u_0.y) * vec2<f32>(sqrt(_S157));
    return vec3<f32>(turn_0.y, turn_0.x, sqrt(1.0f - _S157));
}

fn is_rough_0( lobe_3 : Lobe_0) -> bool
{
    var _S158 : bool;
    if((lobe_3.kind_1) == u32(2))
    {
        _S158 = true;
    }
    else
    {
        _S158 = (lobe_3.kind_1) == u32(4);
    }
    return _S158;
}

struct Microfacets_0
{
     distribution_1 : u32,
     alpha_1 : vec2<f32>,
};

fn facets_of_0( lobe_4 : Lobe_0,  numbers_5 : Numbers_0) -> Microfacets_0
{
    var facets_0 : Microfacets_0;
    facets_0.distribution_1 = lobe_4.distribution_0;
    facets_0.alpha_1 = max(numbers_5.alpha_0, vec2<f32>(0.00009999999747379f));
    return facets_0;
}

struct Stretched_0
{
     sine_1 : f32,
     cosine_3 : f32,
     around_0 : vec2<f32>,
     length_0 : f32,
};

fn stretched_0( facets_1 : Microfacets_0,  wi_2 : vec3<f32>) -> Stretched_0
{
    var longer_0 : vec3<f32> = vec3<f32>(wi_2.xy * facets_1.alpha_1, wi_2.z);
    var view_0 : Stretched_0;
    var _S159 : f32 = length(longer_0);
    view_0.length_0 = _S159;
    var longer_1 : vec3<f32> = longer_0 / vec3<f32>(_S159);
    var _S160 : vec2<f32> = longer_1.xy;
    var _S161 : f32 = length(_S160);
    view_0.sine_1 = _S161;
    view_0.cosine_3 = longer_1.z;
    var _S162 : vec2<f32>;
    if(_S161 > 0.0f)
    {
        _S162 = _S160 / vec2<f32>(view_0.sine_1);
    }
    else
    {
        _S162 = vec2<f32>(1.0f, 0.0f);
    }
    view_0.around_0 = _S162;
    return view_0;
}

fn ggx_normal_0( view_1 : Stretched_0,  u_1 : vec2<f32>) -> vec3<f32>
{
    var _S163 : f32 = u_1.x;
    var radius_0 : f32 = sqrt(_S163);
    var turn_1 : vec2<f32> = sine_cosine_0(6.28318548202514648f * u_1.y);
    var across_2 : f32 = radius_0 * turn_1.y;
    var along_0 : f32 = radius_0 * turn_1.x;
    var visible_0 : f32 = 0.5f * (1.0f + view_1.cosine_3);
    var hidden_0 : f32 = 1.0f - visible_0;
    var _S164 : f32 = 1.0f - _S163;
    var edge_0 : f32 = sqrt(_S164 + along_0 * along_0);
    var up_0 : f32 = hidden_0 * edge_0 + visible_0 * along_0;
    var from_top_0 : f32 = edge_0 - along_0;
    var from_bottom_0 : f32 = edge_0 + along_0;
    var from_top_1 : f32;
    var from_bottom_1 : f32;
    if(along_0 > 0.0f)
    {
        from_top_1 = _S164 / from_bottom_0;
        from_bottom_1 = from_bottom_0;
    }
    else
    {
        var _S165 : f32 = _S164 / from_top_0;
        from_top_1 = from_top_0;
        from_bottom_1 = _S165;
    }
    var towards_0 : f32 = sqrt(visible_0 * from_top_1 * (2.0f * hidden_0 * edge_0 + visible_0 * from_bottom_1));
    return vec3<f32>(towards_0 * view_1.sine_1 - up_0 * view_1.cosine_3, across_2, max(towards_0 * view_1.cosine_3 + up_0 * view_1.sine_1, 0.0f));
}

fn exponential_0( x_5 : f32) -> f32
{
    if(x_5 < -87.0f)
    {
        return 0.0f;
    }
    var power_0 : f32 = floor(x_5 * 1.4426950216293335f + 0.5f);
    var r_0 : f32 = x_5 - power_0 * 0.693359375f + power_0 * 0.00021219444170129f;
    return ((((((0.00019875691214111f * r_0 + 0.00139819993637502f) * r_0 + 0.00833345204591751f) * r_0 + 0.04166579619050026f) * r_0 + 0.1666666567325592f) * r_0 + 0.5f) * r_0 * r_0 + r_0 + 1.0f) * (bitcast<f32>(((u32(i32(power_0) + i32(127)) << (u32(23))))));
}

fn error_function_plus_one_0( x_6 : f32) -> vec2<f32>
{
    var _S166 : f32 = min(abs(x_6), 6.0f);
    var gaussian_0 : f32 = exponential_0(- _S166 * _S166);
    var place_14 : f32 = (_S166 - 2.0f) / (_S166 + 2.0f);
    var complement_0 : f32 = gaussian_0 * (((((((((-0.00042725281673484f * place_14 - 0.00127731403335929f) * place_14 + 0.00131371302995831f) * place_14 + 0.008666617795825f) * place_14 - 0.00805134233087301f) * place_14 - 0.05421232059597969f) * place_14 + 0.1640533059835434f) * place_14 - 0.16603080928325653f) * place_14 - 0.09276388585567474f) * place_14 + 1.27697837352752686f) / (1.0f + 2.0f * _S166);
    var _S167 : f32;
    if(x_6 < 0.0f)
    {
        _S167 = complement_0;
    }
    else
    {
        _S167 = 2.0f - complement_0;
    }
    return vec2<f32>(_S167, 1.128379225730896f * gaussian_0);
}

fn visible_over_cos_0( facets_2 : Microfacets_0,  w_2 : vec3<f32>) -> f32
{
    var stretched_1 : vec2<f32> = w_2.xy * facets_2.alpha_1;
    var spread2_0 : f32 = dot(stretched_1, stretched_1);
    var _S168 : f32 = w_2.z;
    var z2_0 : f32 = _S168 * _S168;
    if((facets_2.distribution_1) == u32(1))
    {
        return 2.0f / (_S168 + sqrt(z2_0 + spread2_0));
    }
    if(z2_0 >= (36.0f * spread2_0))
    {
        return 1.0f / _S168;
    }
    var spread_0 : f32 = sqrt(spread2_0);
    var both_0 : vec2<f32> = error_function_plus_one_0(_S168 / spread_0);
    return 2.0f / (_S168 * both_0.x + 0.5f * spread_0 * both_0.y);
}

fn logarithm_0( x_7 : f32) -> f32
{
    var bits_0 : u32 = (bitcast<u32>((x_7)));
    var power_1 : f32 = f32(i32((bits_0 >> (u32(23)))) - i32(126));
    var m_0 : f32 = (bitcast<f32>(((((bits_0 & (u32(8388607)))) | (u32(1056964608))))));
    var m_1 : f32;
    var power_2 : f32;
    if(m_0 < 0.70710676908493042f)
    {
        var power_3 : f32 = power_1 - 1.0f;
        m_1 = m_0 + m_0;
        power_2 = power_3;
    }
    else
    {
        m_1 = m_0;
        power_2 = power_1;
    }
    var m_2 : f32 = m_1 - 1.0f;
    var z_1 : f32 = m_2 * m_2;
    return m_2 + (((((((((0.07037683576345444f * m_2 - 0.11514610052108765f) * m_2 + 0.11676998436450958f) * m_2 - 0.12420140951871872f) * m_2 + 0.14249323308467865f) * m_2 - 0.16668057441711426f) * m_2 + 0.20000714063644409f) * m_2 - 0.24999994039535522f) * m_2 + 0.33333331346511841f) * m_2 * z_1 - 0.00021219444170129f * power_2 - 0.5f * z_1) + 0.693359375f * power_2;
}

fn error_function_inverse_0( p_0 : f32) -> f32
{
    var w_3 : f32 = - logarithm_0((1.0f - p_0) * (1.0f + p_0));
    if(w_3 < 5.0f)
    {
        var w_4 : f32 = w_3 - 2.5f;
        return ((((((((2.81022636272609816e-08f * w_4 + 3.43273939051869093e-07f) * w_4 - 3.52338770426285919e-06f) * w_4 - 4.39150653619435616e-06f) * w_4 + 0.00021858086984139f) * w_4 - 0.00125372502952814f) * w_4 - 0.00417768163606524f) * w_4 + 0.24664072692394257f) * w_4 + 1.50140941143035889f) * p_0;
    }
    var w_5 : f32 = sqrt(w_3) - 3.0f;
    return ((((((((-0.0002002142573474f * w_5 + 0.00010095055768033f) * w_5 + 0.00134934321977198f) * w_5 - 0.00367342843674123f) * w_5 + 0.00573950773105025f) * w_5 - 0.00762246130034328f) * w_5 + 0.00943887047469616f) * w_5 + 1.00167405605316162f) * w_5 + 2.8329768180847168f) * p_0;
}

fn beckmann_normal_0( view_2 : Stretched_0,  visible_1 : f32,  u_2 : vec2<f32>) -> vec3<f32>
{
    var steepest_0 : f32;
    if((view_2.sine_1 * 6.0f) > (view_2.cosine_3))
    {
        steepest_0 = view_2.cosine_3 / view_2.sine_1;
    }
    else
    {
        steepest_0 = 6.0f;
    }
    var target_0 : f32 = u_2.x * (2.0f / (visible_1 * view_2.length_0));
    var _S169 : f32 = max(view_2.cosine_3, view_2.sine_1);
    var slope_0 : f32 = clamp(error_function_inverse_0(clamp(target_0 / _S169 - 1.0f, -0.99999994039535522f, 0.99999994039535522f)) + -0.5f * view_2.sine_1 / _S169, -6.0f, 0.5f * steepest_0);
    var low_3 : f32 = -6.0f;
    var high_0 : f32 = steepest_0;
    var step_0 : u32 = u32(0);
    for(;;)
    {
        if(step_0 < u32(32))
        {
        }
        else
        {
            break;
        }
        var both_1 : vec2<f32> = error_function_plus_one_0(slope_0);
        var _S170 : f32 = both_1.y;
        var error_0 : f32 = view_2.cosine_3 * both_1.x + 0.5f * view_2.sine_1 * _S170 - target_0;
        var own_0 : f32 = _S170 * (view_2.cosine_3 - slope_0 * view_2.sine_1);
        var bend_0 : f32 = -2.0f * slope_0 * own_0 - _S170 * view_2.sine_1;
        if(error_0 > 0.0f)
        {
            high_0 = slope_0;
        }
        else
        {
            low_3 = slope_0;
        }
        var next_0 : f32 = slope_0 - error_0 * own_0 / (own_0 * own_0 - 0.5f * error_0 * bend_0);
        var _S171 : bool;
        if(next_0 >= low_3)
        {
            _S171 = next_0 <= high_0;
        }
        else
        {
            _S171 = false;
        }
        var next_1 : f32;
        if(!_S171)
        {
            next_1 = 0.5f * (low_3 + high_0);
        }
        else
        {
            next_1 = next_0;
        }
        if((abs(next_1 - slope_0)) < 0.00030000001424924f)
        {
            slope_0 = next_1;
            break;
        }
        var _S172 : u32 = step_0 + u32(1);
        slope_0 = next_1;
        step_0 = _S172;
    }
    return vec3<f32>(- slope_0, error_function_inverse_0(max(2.0f * u_2.y - 1.0f, -0.99999994039535522f)), 1.0f);
}

fn mirrored_at_facet_0( facets_3 : Microfacets_0,  wi_3 : vec3<f32>,  u_3 : vec2<f32>) -> vec3<f32>
{
    var view_3 : Stretched_0 = stretched_0(facets_3, wi_3);
    var normal_1 : vec3<f32>;
    if((facets_3.distribution_1) == u32(1))
    {
        normal_1 = ggx_normal_0(view_3, u_3);
    }
    else
    {
        normal_1 = beckmann_normal_0(view_3, visible_over_cos_0(facets_3, wi_3), u_3);
    }
    var _S173 : f32 = view_3.around_0.x;
    var _S174 : f32 = normal_1.x;
    var _S175 : f32 = view_3.around_0.y;
    var _S176 : f32 = normal_1.y;
    var normal_2 : vec3<f32> = normalize(vec3<f32>(vec2<f32>(_S173 * _S174 - _S175 * _S176, _S175 * _S174 + _S173 * _S176) * facets_3.alpha_1, normal_1.z));
    return normalize(normal_2 * vec3<f32>((2.0f * dot(wi_3, normal_2))) - wi_3);
}

struct Drawn_0
{
     wo_0 : vec3<f32>,
     is_specular_0 : bool,
     probability_0 : f32,
};

fn draw_0( lobe_5 : Lobe_0,  wi_4 : vec3<f32>,  choice_0 : f32,  u_4 : vec2<f32>) -> Drawn_0
{
    var _S177 : bool = (lobe_5.kind_1) == u32(0);
    var has_base_0 : bool;
    if(_S177)
    {
        has_base_0 = true;
    }
    else
    {
        has_base_0 = (lobe_5.kind_1) == u32(3);
    }
    if(has_base_0)
    {
        has_base_0 = true;
    }
    else
    {
        has_base_0 = (lobe_5.kind_1) == u32(4);
    }
    var of_base_1 : f32;
    if(_S177)
    {
        of_base_1 = 1.0f;
    }
    else
    {
        of_base_1 = 0.0f;
    }
    var _S178 : bool;
    if((lobe_5.kind_1) == u32(3))
    {
        _S178 = true;
    }
    else
    {
        _S178 = (lobe_5.kind_1) == u32(4);
    }
    if(_S178)
    {
        of_base_1 = base_probability_0(lobe_5.numbers_2, transmittance_0(lobe_5, coat_eta_0(lobe_5.numbers_2), wi_4.z));
    }
    var drawn_0 : Drawn_0;
    drawn_0.is_specular_0 = false;
    drawn_0.probability_0 = 1.0f;
    if(has_base_0)
    {
        has_base_0 = choice_0 < of_base_1;
    }
    else
    {
        has_base_0 = false;
    }
    if(has_base_0)
    {
        drawn_0.wo_0 = sample_cosine_0(u_4);
    }
    else
    {
        if(is_rough_0(lobe_5))
        {
            drawn_0.wo_0 = mirrored_at_facet_0(facets_of_0(lobe_5, lobe_5.numbers_2), wi_4, u_4);
        }
        else
        {
            drawn_0.wo_0 = vec3<f32>((vec2<f32>(0) - wi_4.xy), wi_4.z);
            drawn_0.is_specular_0 = true;
            drawn_0.probability_0 = 1.0f - of_base_1;
        }
    }
    return drawn_0;
}

fn to_world_0( axes_3 : Axes_0,  v_3 : vec3<f32>) -> vec3<f32>
{
    return axes_3.s_0 * vec3<f32>(v_3.x) + axes_3.t_0 * vec3<f32>(v_3.y) + axes_3.n_1 * vec3<f32>(v_3.z);
}

fn limit_at_0( which_5 : u32) -> f64
{
    return primitives_0[word_0(u32(15)) + which_5];
}

struct LightSample_0
{
     direction_5 : vec3<f32>,
     wo_1 : vec3<f32>,
     way_0 : vec3<f64>,
     nearest_0 : f64,
     farthest_0 : f64,
     is_on_emitter_0 : bool,
     emitter_0 : u32,
     probability_1 : f32,
     pdf_0 : f32,
     distance_0 : f32,
     place_15 : Place_0,
     is_specular_1 : bool,
};

fn sample_material_0( vertex_1 : Vertex_0,  key_4 : vec2<u32>,  first_3 : u32) -> LightSample_0
{
    var drawn_1 : Drawn_0 = draw_0(vertex_1.lobe_1, value_of_0(vertex_1.wi_1), random_0(key_4, first_3), random_pair_0(key_4, first_3 + u32(1)));
    var sample_0 : LightSample_0;
    sample_0.is_on_emitter_0 = false;
    sample_0.is_specular_1 = drawn_1.is_specular_0;
    sample_0.probability_1 = drawn_1.probability_0;
    sample_0.wo_1 = drawn_1.wo_0;
    var _S179 : vec3<f32> = normalize(to_world_0(vertex_1.axes_1, drawn_1.wo_0));
    sample_0.direction_5 = _S179;
    sample_0.way_0 = vec3<f64>(_S179);
    sample_0.nearest_0 = limit_at_0(u32(2));
    sample_0.farthest_0 = limit_at_0(u32(1));
    sample_0.emitter_0 = u32(4294967295);
    sample_0.distance_0 = 0.0f;
    sample_0.pdf_0 = 0.0f;
    sample_0.place_15 = vertex_1.surface_4.place_3;
    return sample_0;
}

fn exact_unit_0( v_4 : vec3<f64>) -> vec3<f64>
{
    return v_4 / vec3<f64>(sqrt(dot(v_4, v_4)));
}

struct Mirror_0
{
     corner_2 : vec3<f64>,
     ab_1 : vec3<f64>,
     ac_1 : vec3<f64>,
     normal_3 : vec3<f64>,
};

fn mirror_at_0( triangle_7 : u32) -> Mirror_0
{
    var at_19 : u32 = u32(9) * triangle_7;
    var mirror_0 : Mirror_0;
    var _S180 : vec3<f64> = primitive_vector_0(at_19);
    mirror_0.corner_2 = _S180;
    var _S181 : vec3<f64> = primitive_vector_0(at_19 + u32(3)) - _S180;
    mirror_0.ab_1 = _S181;
    var _S182 : vec3<f64> = primitive_vector_0(at_19 + u32(6)) - _S180;
    mirror_0.ac_1 = _S182;
    mirror_0.normal_3 = exact_unit_0(cross(_S181, _S182));
    return mirror_0;
}

struct Around_0
{
     position_1 : vec3<f64>,
     face_0 : vec3<f64>,
     tree_0 : u32,
     mirrors_0 : u32,
     occluder_0 : u32,
};

fn around_vertex_0( vertex_2 : Vertex_0,  depth_3 : u32) -> Around_0
{
    var face_1 : Mirror_0 = mirror_at_0(vertex_2.surface_4.place_3.triangle_0);
    var around_1 : Around_0;
    around_1.position_1 = vertex_2.surface_4.exact_0;
    around_1.face_0 = face_1.normal_3;
    around_1.tree_0 = edge_word_0(u32(1));
    around_1.mirrors_0 = min(word_0(u32(0)) - min(word_0(u32(0)), depth_3 + u32(2)), edge_word_0(u32(8)));
    around_1.occluder_0 = u32(4294967295);
    return around_1;
}

fn first_number_0( depth_4 : u32) -> u32
{
    return edge_word_0(u32(6)) + depth_4 * edge_word_0(u32(7));
}

fn real_place_0( at_20 : u32) -> u32
{
    return word_0(u32(15)) + u32(4) + at_20;
}

fn edge_real_0( at_21 : u32) -> f64
{
    return primitives_0[real_place_0(at_21)];
}

fn walked_1( direction_6 : vec3<f64>,  tangent_2 : vec3<f64>,  half_sine_0 : f64) -> vec3<f64>
{
    var squared_1 : f64 = half_sine_0 * half_sine_0;
    return direction_6 * vec3<f64>((1.0lf - 2.0lf * squared_1)) + tangent_2 * vec3<f64>((2.0lf * half_sine_0 * sqrt(1.0lf - squared_1)));
}

fn length_of_0( v_5 : vec3<f64>) -> f64
{
    return sqrt(dot(v_5, v_5));
}

fn half_tangent_between_0( a_15 : vec3<f64>,  b_10 : vec3<f64>) -> f64
{
    var beside_0 : f64 = 1.0lf + dot(a_15, b_10);
    var _S183 : f64;
    if(beside_0 > 0.0lf)
    {
        _S183 = length_of_0(cross(a_15, b_10)) / beside_0;
    }
    else
    {
        _S183 = limit_at_0(u32(1));
    }
    return _S183;
}

fn component_0( v_6 : vec3<f64>,  axis_0 : u32) -> f64
{
    var _S184 : f64;
    if(axis_0 == u32(0))
    {
        _S184 = v_6.x;
    }
    else
    {
        if(axis_0 == u32(1))
        {
            _S184 = v_6.y;
        }
        else
        {
            _S184 = v_6.z;
        }
    }
    return _S184;
}

struct Ray_0
{
     origin_0 : vec3<f64>,
     shear_x_0 : f64,
     shear_y_0 : f64,
     inverse_z_0 : f64,
     t_min_0 : f64,
     t_max_0 : f64,
     local_per_t_0 : f64,
     enter_0 : f64,
     edge_on_0 : f64,
     largest_0 : f64,
};

fn ray_along_0( origin_1 : vec3<f64>,  direction_7 : vec3<f64>,  t_min_1 : f64,  t_max_1 : f64,  axes_4 : ptr<function, u32>) -> Ray_0
{
    var size_2 : vec3<f32> = abs(vec3<f32>(direction_7));
    var _S185 : f32 = size_2.x;
    var _S186 : f32 = size_2.y;
    var _S187 : bool;
    if(_S185 >= _S186)
    {
        _S187 = _S185 >= (size_2.z);
    }
    else
    {
        _S187 = false;
    }
    var _S188 : i32;
    if(_S187)
    {
        _S188 = i32(0);
    }
    else
    {
        if(_S186 >= (size_2.z))
        {
            _S188 = i32(1);
        }
        else
        {
            _S188 = i32(2);
        }
    }
    var z_2 : u32 = u32(_S188);
    var x_8 : u32 = (z_2 + u32(1)) % u32(3);
    var y_1 : u32 = (z_2 + u32(2)) % u32(3);
    (*axes_4) = (((x_8 | (((y_1 << (u32(2))))))) | (((z_2 << (u32(4))))));
    var ray_0 : Ray_0;
    ray_0.origin_0 = origin_1;
    var along_1 : f64 = component_0(direction_7, z_2);
    ray_0.inverse_z_0 = 1.0lf / along_1;
    ray_0.shear_x_0 = component_0(direction_7, x_8) / along_1;
    ray_0.shear_y_0 = component_0(direction_7, y_1) / along_1;
    ray_0.t_min_0 = t_min_1;
    ray_0.t_max_0 = t_max_1;
    ray_0.local_per_t_0 = abs(along_1);
    ray_0.enter_0 = 0.0lf;
    ray_0.edge_on_0 = limit_at_0(u32(0));
    ray_0.largest_0 = limit_at_0(u32(1));
    return ray_0;
}

fn ray_along_1( origin_2 : vec3<f64>,  direction_8 : vec3<f64>,  t_min_2 : f64,  t_max_2 : f64,  axes_5 : ptr<function, u32>) -> Ray_0
{
    var size_3 : vec3<f32> = abs(vec3<f32>(direction_8));
    var _S189 : f32 = size_3.x;
    var _S190 : f32 = size_3.y;
    var _S191 : bool;
    if(_S189 >= _S190)
    {
        _S191 = _S189 >= (size_3.z);
    }
    else
    {
        _S191 = false;
    }
    var _S192 : i32;
    if(_S191)
    {
        _S192 = i32(0);
    }
    else
    {
        if(_S190 >= (size_3.z))
        {
            _S192 = i32(1);
        }
        else
        {
            _S192 = i32(2);
        }
    }
    var z_3 : u32 = u32(_S192);
    var x_9 : u32 = (z_3 + u32(1)) % u32(3);
    var y_2 : u32 = (z_3 + u32(2)) % u32(3);
    (*axes_5) = (((x_9 | (((y_2 << (u32(2))))))) | (((z_3 << (u32(4))))));
    var ray_1 : Ray_0;
    ray_1.origin_0 = origin_2;
    var along_2 : f64 = component_0(direction_8, z_3);
    ray_1.inverse_z_0 = 1.0lf / along_2;
    ray_1.shear_x_0 = component_0(direction_8, x_9) / along_2;
    ray_1.shear_y_0 = component_0(direction_8, y_2) / along_2;
    ray_1.t_min_0 = t_min_2;
    ray_1.t_max_0 = t_max_2;
    ray_1.local_per_t_0 = abs(along_2);
    ray_1.enter_0 = 0.0lf;
    ray_1.edge_on_0 = limit_at_0(u32(0));
    ray_1.largest_0 = limit_at_0(u32(1));
    return ray_1;
}

fn ray_child_0( node_0 : u32,  slot_2 : u32) -> u32
{
    return nodes_0[u32(14) * node_0 + u32(12) + slot_2 / u32(4)][slot_2 % u32(4)];
}

struct RayView_0
{
     inverse_0 : vec3<f32>,
     offset_near_0 : vec3<f32>,
     offset_far_0 : vec3<f32>,
     limit_0 : f32,
     margin_0 : f32,
     axes_6 : u32,
};

fn ray_bound_0( view_4 : RayView_0,  limit_1 : f32,  node_1 : u32,  slot_3 : u32) -> f32
{
    var _S193 : u32 = u32(14) * node_1 + slot_3 / u32(4);
    var near_0 : f32 = 0.0f;
    var far_0 : f32 = limit_1;
    var axis_1 : u32 = u32(0);
    for(;;)
    {
        if(axis_1 < u32(3))
        {
        }
        else
        {
            break;
        }
        var _S194 : u32 = axis_1;
        var _S195 : u32 = _S193 + u32(2) * axis_1;
        var _S196 : u32 = slot_3 % u32(4);
        var low_4 : f32 = (bitcast<f32>((nodes_0[_S195][_S196])));
        var high_1 : f32 = (bitcast<f32>((nodes_0[_S195 + u32(6)][_S196])));
        var _S197 : bool = (view_4.inverse_0[axis_1]) < 0.0f;
        var _S198 : f32;
        if(_S197)
        {
            _S198 = high_1;
        }
        else
        {
            _S198 = low_4;
        }
        var _S199 : f32 = max(near_0, _S198 * view_4.inverse_0[_S194] - view_4.offset_near_0[axis_1]);
        var _S200 : f32;
        if(_S197)
        {
            _S200 = low_4;
        }
        else
        {
            _S200 = high_1;
        }
        var _S201 : f32 = min(far_0, _S200 * view_4.inverse_0[_S194] - view_4.offset_far_0[axis_1]);
        var _S202 : u32 = axis_1 + u32(1);
        near_0 = _S199;
        far_0 = _S201;
        axis_1 = _S202;
    }
    if(near_0 <= far_0)
    {
    }
    else
    {
        near_0 = 3.00000000549775576e+38f;
    }
    return near_0;
}

fn nearest_first_0( bounds_0 : array<f32, i32(8)>,  limit_2 : f32) -> u32
{
    var k_3 : u32 = u32(0);
    var order_0 : u32 = u32(0);
    for(;;)
    {
        if(k_3 < u32(8))
        {
        }
        else
        {
            break;
        }
        var _S203 : u32 = k_3;
        if((bounds_0[k_3]) > limit_2)
        {
            k_3 = k_3 + u32(1);
            continue;
        }
        var j_0 : u32 = u32(0);
        var rank_0 : u32 = u32(0);
        for(;;)
        {
            if(j_0 < u32(8))
            {
            }
            else
            {
                break;
            }
            var _S204 : u32 = j_0;
            var _S205 : bool;
            if((bounds_0[j_0]) < (bounds_0[_S203]))
            {
                _S205 = true;
            }
            else
            {
                if((bounds_0[_S204]) == (bounds_0[_S203]))
                {
                    _S205 = j_0 < k_3;
                }
                else
                {
                    _S205 = false;
                }
            }
            if(_S205)
            {
                rank_0 = rank_0 + u32(1);
            }
            j_0 = j_0 + u32(1);
        }
        order_0 = (order_0 | ((((k_3 + u32(1)) << ((u32(4) * rank_0))))));
        k_3 = k_3 + u32(1);
    }
    return order_0;
}

fn crossed_0( view_5 : RayView_0,  limit_3 : f32,  node_2 : u32) -> u32
{
    var bounds_1 : array<f32, i32(8)>;
    var slot_4 : u32 = u32(0);
    for(;;)
    {
        if(slot_4 < u32(8))
        {
        }
        else
        {
            break;
        }
        var _S206 : f32;
        if((ray_child_0(node_2, slot_4)) == u32(4294967295))
        {
            _S206 = 3.00000000549775576e+38f;
        }
        else
        {
            _S206 = ray_bound_0(view_5, limit_3, node_2, slot_4);
        }
        bounds_1[slot_4] = _S206;
        slot_4 = slot_4 + u32(1);
    }
    return nearest_first_0(bounds_1, limit_3);
}

fn rounded_0( product_1 : f64,  largest_1 : f64) -> f64
{
    return min(product_1, largest_1);
}

fn corner_3( ray_2 : Ray_0,  axes_7 : u32,  at_22 : u32) -> vec3<f64>
{
    var relative_0 : vec3<f64> = primitive_vector_0(at_22) - ray_2.origin_0;
    var z_4 : f64 = component_0(relative_0, (axes_7 >> (u32(4))));
    return vec3<f64>(component_0(relative_0, (axes_7 & (u32(3)))) - rounded_0(ray_2.shear_x_0 * z_4, ray_2.largest_0), component_0(relative_0, (((axes_7 >> (u32(2)))) & (u32(3)))) - rounded_0(ray_2.shear_y_0 * z_4, ray_2.largest_0), z_4);
}

struct Crossing_0
{
     is_hit_0 : bool,
     t_1 : f64,
     v_7 : f64,
     w_6 : f64,
};

fn intersect_0( ray_3 : Ray_0,  axes_8 : u32,  at_23 : u32) -> Crossing_0
{
    var crossing_0 : Crossing_0;
    crossing_0.is_hit_0 = false;
    crossing_0.t_1 = 0.0lf;
    crossing_0.v_7 = 0.0lf;
    crossing_0.w_6 = 0.0lf;
    var a_16 : vec3<f64> = corner_3(ray_3, axes_8, at_23);
    var b_11 : vec3<f64> = corner_3(ray_3, axes_8, at_23 + u32(3));
    var c_4 : vec3<f64> = corner_3(ray_3, axes_8, at_23 + u32(6));
    var _S207 : f64 = c_4.x;
    var _S208 : f64 = b_11.y;
    var cx_by_0 : f64 = rounded_0(_S207 * _S208, ray_3.largest_0);
    var _S209 : f64 = c_4.y;
    var _S210 : f64 = b_11.x;
    var cy_bx_0 : f64 = rounded_0(_S209 * _S210, ray_3.largest_0);
    var _S211 : f64 = a_16.x;
    var ax_cy_0 : f64 = rounded_0(_S211 * _S209, ray_3.largest_0);
    var _S212 : f64 = a_16.y;
    var ay_cx_0 : f64 = rounded_0(_S212 * _S207, ray_3.largest_0);
    var bx_ay_0 : f64 = rounded_0(_S210 * _S212, ray_3.largest_0);
    var by_ax_0 : f64 = rounded_0(_S208 * _S211, ray_3.largest_0);
    var u_5 : f64 = cx_by_0 - cy_bx_0;
    var v_8 : f64 = ax_cy_0 - ay_cx_0;
    var w_7 : f64 = bx_ay_0 - by_ax_0;
    var _S213 : f64 = min(min(u_5, v_8), w_7);
    var _S214 : f64 = max(max(u_5, v_8), w_7);
    var _S215 : bool;
    if(_S213 < 0.0lf)
    {
        _S215 = _S214 > 0.0lf;
    }
    else
    {
        _S215 = false;
    }
    if(_S215)
    {
        return crossing_0;
    }
    var determinant_0 : f64 = u_5 + v_8 + w_7;
    if(_S213 <= 0.0lf)
    {
        _S215 = _S214 >= 0.0lf;
    }
    else
    {
        _S215 = false;
    }
    if(_S215)
    {
        if((abs(determinant_0)) <= (ray_3.edge_on_0 * (abs(cx_by_0) + abs(cy_bx_0) + abs(ax_cy_0) + abs(ay_cx_0) + abs(bx_ay_0) + abs(by_ax_0))))
        {
            return crossing_0;
        }
    }
    if(determinant_0 == 0.0lf)
    {
        return crossing_0;
    }
    var t_2 : f64 = (rounded_0(u_5 * a_16.z, ray_3.largest_0) + rounded_0(v_8 * b_11.z, ray_3.largest_0) + rounded_0(w_7 * c_4.z, ray_3.largest_0)) / determinant_0 * ray_3.inverse_z_0;
    if((ray_3.t_min_0) <= t_2)
    {
        _S215 = t_2 <= (ray_3.t_max_0);
    }
    else
    {
        _S215 = false;
    }
    crossing_0.is_hit_0 = _S215;
    crossing_0.t_1 = t_2;
    crossing_0.v_7 = v_8 / determinant_0;
    crossing_0.w_6 = w_7 / determinant_0;
    return crossing_0;
}

fn face_2( triangle_8 : u32) -> u32
{
    return rough_0[triangle_8 / u32(4)][triangle_8 % u32(4)];
}

struct Found_0
{
     face_3 : u32,
     triangle_9 : u32,
     v_9 : f64,
     w_8 : f64,
};

fn first_found_0( view_6 : RayView_0,  ray_4 : ptr<function, Ray_0>,  any_0 : bool) -> Found_0
{
    var _S216 : bool;
    var found_0 : Found_0;
    found_0.face_3 = u32(4294967295);
    found_0.triangle_9 = u32(4294967295);
    found_0.v_9 = 0.0lf;
    found_0.w_8 = 0.0lf;
    if(!((view_6.limit_0) >= 0.0f))
    {
        return found_0;
    }
    var way_1 : array<vec2<u32>, i32(40)>;
    way_1[i32(0)] = vec2<u32>(u32(0), u32(0));
    var entered_0 : u32 = u32(0);
    var limit_4 : f32 = view_6.limit_0;
    var is_new_0 : bool = true;
    var level_0 : u32 = u32(0);
    for(;;)
    {
        var entered_1 : u32;
        var is_new_1 : bool;
        if(entered_0 != u32(4294967295))
        {
            way_1[level_0] = vec2<u32>(entered_0, crossed_0(view_6, limit_4, entered_0));
            is_new_1 = true;
            entered_1 = u32(4294967295);
        }
        else
        {
            is_new_1 = is_new_0;
            entered_1 = entered_0;
        }
        var here_1 : vec2<u32> = way_1[level_0];
        var _S217 : u32 = way_1[level_0].y;
        if(_S217 == u32(0))
        {
            if(level_0 == u32(0))
            {
                break;
            }
            var _S218 : u32 = level_0 - u32(1);
            entered_0 = entered_1;
            is_new_0 = is_new_1;
            level_0 = _S218;
            continue;
        }
        var slot_5 : u32 = ((_S217 & (u32(15)))) - u32(1);
        way_1[level_0][i32(1)] = (_S217 >> (u32(4)));
        var _S219 : bool;
        if(!is_new_1)
        {
            _S219 = (ray_bound_0(view_6, limit_4, here_1.x, slot_5)) > limit_4;
        }
        else
        {
            _S219 = false;
        }
        if(_S219)
        {
            entered_0 = entered_1;
            is_new_0 = is_new_1;
            continue;
        }
        var child_0 : u32 = ray_child_0(here_1.x, slot_5);
        if(((child_0 & (u32(2147483648)))) == u32(0))
        {
            var _S220 : u32 = level_0 + u32(1);
            entered_0 = child_0;
            is_new_0 = false;
            level_0 = _S220;
            continue;
        }
        var leaf_0 : u32 = (child_0 & (u32(2147483647)));
        var _S221 : u32 = leaf_starts_0[leaf_0 + u32(1)];
        var _S222 : u32 = leaf_starts_0[leaf_0];
        var limit_5 : f32 = limit_4;
        var i_1 : u32 = _S222;
        for(;;)
        {
            if(i_1 < _S221)
            {
            }
            else
            {
                break;
            }
            var crossing_1 : Crossing_0 = intersect_0((*ray_4), view_6.axes_6, u32(9) * i_1);
            if(!crossing_1.is_hit_0)
            {
                i_1 = i_1 + u32(1);
                continue;
            }
            if((found_0.face_3) == u32(4294967295))
            {
                _S216 = true;
            }
            else
            {
                _S216 = (crossing_1.t_1) < ((*ray_4).t_max_0);
            }
            var _S223 : bool;
            if(_S216)
            {
                _S223 = true;
            }
            else
            {
                _S223 = (face_2(i_1)) < (found_0.face_3);
            }
            var limit_6 : f32;
            if(_S223)
            {
                found_0.face_3 = face_2(i_1);
                found_0.triangle_9 = i_1;
                (*ray_4).t_max_0 = crossing_1.t_1;
                found_0.v_9 = crossing_1.v_7;
                found_0.w_8 = crossing_1.w_6;
                limit_6 = min(limit_5, f32(crossing_1.t_1 * (*ray_4).local_per_t_0 - (*ray_4).enter_0) + 2.0f * view_6.margin_0);
            }
            else
            {
                limit_6 = limit_5;
            }
            limit_5 = limit_6;
            i_1 = i_1 + u32(1);
        }
        if(any_0)
        {
            _S216 = (found_0.face_3) != u32(4294967295);
        }
        else
        {
            _S216 = false;
        }
        if(_S216)
        {
            break;
        }
        entered_0 = entered_1;
        limit_4 = limit_5;
        is_new_0 = false;
    }
    return found_0;
}

fn cast_0( origin_3 : vec3<f64>,  direction_9 : vec3<f64>,  t_min_3 : f64,  t_max_3 : f64,  any_1 : bool,  t_3 : ptr<function, f32>) -> Found_0
{
    var view_7 : RayView_0;
    var _S224 : u32 = view_7.axes_6;
    var _S225 : Ray_0 = ray_along_1(origin_3, direction_9, t_min_3, t_max_3, &(_S224));
    view_7.axes_6 = _S224;
    var ray_5 : Ray_0 = _S225;
    var _S226 : vec3<f32> = vec3<f32>(direction_9 / vec3<f64>(ray_5.local_per_t_0));
    var axis_2 : u32 = u32(0);
    for(;;)
    {
        if(axis_2 < u32(3))
        {
        }
        else
        {
            break;
        }
        var _S227 : f32 = max(abs(_S226[axis_2]), 8.67361737988403547e-19f);
        var _S228 : f32;
        if((_S226[axis_2]) < 0.0f)
        {
            _S228 = -1.0f / _S227;
        }
        else
        {
            _S228 = 1.0f / _S227;
        }
        view_7.inverse_0[axis_2] = _S228;
        axis_2 = axis_2 + u32(1);
    }
    var offset_0 : vec3<f32> = vec3<f32>(origin_3) * view_7.inverse_0;
    var wider_0 : vec3<f32> = vec3<f32>(3.814697265625e-06f) * abs(view_7.inverse_0);
    view_7.offset_near_0 = offset_0 + wider_0;
    view_7.offset_far_0 = offset_0 - wider_0;
    view_7.limit_0 = min(f32(t_max_3 * ray_5.local_per_t_0), 8.0f) + 3.814697265625e-06f;
    view_7.margin_0 = 3.814697265625e-06f;
    var found_1 : Found_0 = first_found_0(view_7, &(ray_5), any_1);
    (*t_3) = f32(ray_5.t_max_0);
    return found_1;
}

fn is_mirror_0( triangle_10 : u32) -> bool
{
    return (word_0(shape_of_0(triangle_10) + u32(6))) != u32(0);
}

fn place_of_0( found_2 : Found_0) -> Place_0
{
    return exact_place_0(found_2.triangle_9, found_2.v_9, found_2.w_8);
}

fn mirrored_0( mirror_1 : Mirror_0,  direction_10 : vec3<f64>) -> vec3<f64>
{
    return direction_10 - mirror_1.normal_3 * vec3<f64>((2.0lf * dot(mirror_1.normal_3, direction_10)));
}

fn height_of_0( mirror_2 : Mirror_0,  place_16 : vec3<f64>) -> f64
{
    return dot(mirror_2.normal_3, place_16 - mirror_2.corner_2);
}

fn image_of_0( mirror_3 : Mirror_0,  place_17 : vec3<f64>) -> vec3<f64>
{
    return place_17 - mirror_3.normal_3 * vec3<f64>((2.0lf * height_of_0(mirror_3, place_17)));
}

struct Chain_0
{
     image_0 : vec3<f64>,
     start_0 : vec3<f64>,
     direction_11 : vec3<f64>,
     facing_0 : vec3<f64>,
     count_1 : u32,
     triangles_0 : array<u32, i32(6)>,
};

fn reflect_0( chain_0 : ptr<function, Chain_0>) -> bool
{
    var unused_0 : f32;
    var found_3 : Found_0 = cast_0((*chain_0).start_0, (*chain_0).direction_11, limit_at_0(u32(2)), limit_at_0(u32(1)), false, &(unused_0));
    var _S229 : bool;
    if((found_3.face_3) == u32(4294967295))
    {
        _S229 = true;
    }
    else
    {
        _S229 = !is_mirror_0(found_3.triangle_9);
    }
    if(_S229)
    {
        return false;
    }
    var mirror_4 : Mirror_0 = mirror_at_0(found_3.triangle_9);
    (*chain_0).start_0 = position_of_0(place_of_0(found_3));
    var _S230 : vec3<f64> = mirrored_0(mirror_4, (*chain_0).direction_11);
    (*chain_0).direction_11 = _S230;
    (*chain_0).image_0 = image_of_0(mirror_4, (*chain_0).image_0);
    var _S231 : vec3<f64>;
    if((dot(mirror_4.normal_3, _S230)) < 0.0lf)
    {
        _S231 = (vec3<f64>(0) - mirror_4.normal_3);
    }
    else
    {
        _S231 = mirror_4.normal_3;
    }
    (*chain_0).facing_0 = _S231;
    (*chain_0).triangles_0[(*chain_0).count_1] = found_3.triangle_9;
    (*chain_0).count_1 = (*chain_0).count_1 + u32(1);
    return true;
}

fn limit_by_0( half_tangent_0 : f64) -> vec2<f32>
{
    var _S232 : f32 = min(f32(half_tangent_0), 1.0e+09f);
    var squared_2 : f32 = _S232 * _S232;
    return vec2<f32>(1.0f - squared_2, 2.0f * _S232) / vec2<f32>((1.0f + squared_2));
}

fn edge_number_0( at_24 : u32) -> f32
{
    return (bitcast<f32>((edge_word_0(at_24))));
}

fn edge_vector_0( at_25 : u32) -> vec3<f32>
{
    return vec3<f32>(edge_number_0(at_25), edge_number_0(at_25 + u32(1)), edge_number_0(at_25 + u32(2)));
}

struct Ball_0
{
     from_axis_0 : f32,
     along_3 : f32,
     radius_1 : f32,
};

fn ball_of_0( node_3 : u32,  image_1 : vec3<f32>,  axis_3 : vec3<f32>) -> Ball_0
{
    var offset_1 : vec3<f32> = edge_vector_0(node_3 + u32(4)) - image_1;
    var ball_0 : Ball_0;
    ball_0.from_axis_0 = length(cross(axis_3, offset_1));
    ball_0.along_3 = dot(axis_3, offset_1);
    ball_0.radius_1 = 3.99999998990097083e-06f * (1.0f + length(offset_1)) + edge_number_0(node_3 + u32(7));
    return ball_0;
}

fn is_beyond_0( ball_1 : Ball_0,  limit_7 : vec2<f32>) -> bool
{
    return (ball_1.from_axis_0 * limit_7.x - ball_1.along_3 * limit_7.y) > (ball_1.radius_1);
}

fn comes_first_0( ball_2 : Ball_0,  other_0 : Ball_0) -> bool
{
    var _S233 : f32 = max(ball_2.from_axis_0 - ball_2.radius_1, 0.0f);
    var _S234 : f32 = max(other_0.from_axis_0 - other_0.radius_1, 0.0f);
    var _S235 : bool;
    if(_S233 == _S234)
    {
        _S235 = (ball_2.along_3) < (other_0.along_3);
    }
    else
    {
        _S235 = _S233 < _S234;
    }
    return _S235;
}

fn record_of_0( around_2 : Around_0,  edge_1 : u32) -> u32
{
    return edge_word_0(around_2.tree_0 + u32(1)) + u32(12) * edge_1;
}

fn edge_position_0( at_26 : u32) -> vec3<f64>
{
    return primitive_vector_0(real_place_0(at_26));
}

struct OnEdge_0
{
     t_4 : f64,
     sine_2 : f64,
     cosine_4 : f64,
     offset_2 : vec3<f64>,
};

fn on_edge_0( axis_4 : vec3<f64>,  t_5 : f64,  offset_3 : vec3<f64>) -> OnEdge_0
{
    var place_18 : OnEdge_0;
    place_18.t_4 = t_5;
    place_18.offset_2 = offset_3;
    place_18.sine_2 = length_of_0(cross(axis_4, offset_3));
    place_18.cosine_4 = dot(axis_4, offset_3);
    return place_18;
}

fn is_nearer_0( p_1 : OnEdge_0,  q_0 : OnEdge_0) -> bool
{
    return (p_1.sine_2 * q_0.cosine_4) < (q_0.sine_2 * p_1.cosine_4);
}

struct Candidate_0
{
     half_tangent_1 : f64,
     t_6 : f64,
     edge_2 : u32,
     number_1 : u32,
};

fn closest_on_edge_0( around_3 : Around_0,  chain_1 : Chain_0,  axis_5 : vec3<f64>,  edge_3 : u32,  candidate_0 : ptr<function, Candidate_0>) -> bool
{
    (*candidate_0).edge_2 = edge_3;
    (*candidate_0).number_1 = edge_word_0(record_of_0(around_3, edge_3) + u32(11));
    (*candidate_0).half_tangent_1 = 0.0lf;
    (*candidate_0).t_6 = 0.0lf;
    var numbers_6 : u32 = edge_word_0(around_3.tree_0 + u32(2)) + u32(14) * edge_3;
    var a_17 : vec3<f64> = edge_position_0(numbers_6) - chain_1.image_0;
    var b_12 : vec3<f64> = edge_position_0(numbers_6 + u32(3)) - chain_1.image_0;
    var along_4 : vec3<f64> = b_12 - a_17;
    var from_mirror_0 : vec3<f64> = chain_1.image_0 - chain_1.start_0;
    var _S236 : bool;
    if((dot(a_17 + from_mirror_0, chain_1.facing_0)) < 0.0lf)
    {
        _S236 = (dot(b_12 + from_mirror_0, chain_1.facing_0)) < 0.0lf;
    }
    else
    {
        _S236 = false;
    }
    if(_S236)
    {
        return false;
    }
    var across_3 : vec3<f64> = cross(a_17, along_4);
    if((dot(across_3, across_3)) == 0.0lf)
    {
        _S236 = (dot(a_17, b_12)) <= 0.0lf;
    }
    else
    {
        _S236 = false;
    }
    if(_S236)
    {
        return false;
    }
    var place_19 : OnEdge_0 = on_edge_0(axis_5, 0.0lf, a_17);
    var other_1 : OnEdge_0 = on_edge_0(axis_5, 1.0lf, b_12);
    var place_20 : OnEdge_0;
    if(is_nearer_0(other_1, place_19))
    {
        place_20 = other_1;
    }
    else
    {
        place_20 = place_19;
    }
    var w_9 : vec3<f64> = cross(axis_5, across_3);
    var falls_0 : f64 = dot(along_4, w_9);
    var t_7 : f64;
    if(falls_0 != 0.0lf)
    {
        t_7 = - dot(a_17, w_9) / falls_0;
    }
    else
    {
        t_7 = 0.0lf;
    }
    if(t_7 > 0.0lf)
    {
        _S236 = t_7 < 1.0lf;
    }
    else
    {
        _S236 = false;
    }
    if(_S236)
    {
        var other_2 : OnEdge_0 = on_edge_0(axis_5, t_7, a_17 + along_4 * vec3<f64>(t_7));
        if(is_nearer_0(other_2, place_20))
        {
            place_20 = other_2;
        }
    }
    var beside_1 : f64 = length_of_0(place_20.offset_2) + place_20.cosine_4;
    (*candidate_0).t_6 = place_20.t_4;
    (*candidate_0).half_tangent_1 = place_20.sine_2 / beside_1;
    return beside_1 > 0.0lf;
}

fn is_before_0( a_18 : Candidate_0,  b_13 : Candidate_0) -> bool
{
    var _S237 : bool;
    if((a_18.half_tangent_1) < (b_13.half_tangent_1))
    {
        _S237 = true;
    }
    else
    {
        if((a_18.half_tangent_1) == (b_13.half_tangent_1))
        {
            _S237 = (a_18.number_1) < (b_13.number_1);
        }
        else
        {
            _S237 = false;
        }
    }
    return _S237;
}

struct Candidates_0
{
     listed_0 : array<Candidate_0, i32(4)>,
     count_2 : u32,
};

fn has_room_0( candidates_0 : Candidates_0,  candidate_1 : Candidate_0) -> bool
{
    var _S238 : bool;
    if((candidates_0.count_2) < u32(4))
    {
        _S238 = true;
    }
    else
    {
        _S238 = is_before_0(candidate_1, candidates_0.listed_0[u32(3)]);
    }
    return _S238;
}

fn is_on_horizon_0( around_4 : Around_0,  edge_4 : u32) -> bool
{
    var numbers_7 : u32 = edge_word_0(around_4.tree_0 + u32(2)) + u32(14) * edge_4;
    return (max(abs(dot(edge_position_0(numbers_7) - around_4.position_1, around_4.face_0)), abs(dot(edge_position_0(numbers_7 + u32(3)) - around_4.position_1, around_4.face_0)))) <= (limit_at_0(u32(2)));
}

fn place_of_1( around_5 : Around_0,  candidate_2 : Candidate_0) -> vec3<f64>
{
    var numbers_8 : u32 = edge_word_0(around_5.tree_0 + u32(2)) + u32(14) * candidate_2.edge_2;
    var start_1 : vec3<f64> = edge_position_0(numbers_8);
    return start_1 + (edge_position_0(numbers_8 + u32(3)) - start_1) * vec3<f64>(candidate_2.t_6);
}

fn meets_0( triangle_11 : u32,  origin_4 : vec3<f64>,  direction_12 : vec3<f64>,  t_min_4 : f64,  t_max_4 : f64) -> bool
{
    var axes_9 : u32;
    var ray_6 : Ray_0 = ray_along_0(origin_4, direction_12, t_min_4, t_max_4, &(axes_9));
    return intersect_0(ray_6, axes_9, u32(9) * triangle_11).is_hit_0;
}

fn is_hidden_0( around_6 : Around_0,  candidate_3 : Candidate_0) -> bool
{
    var _S239 : bool;
    if((around_6.occluder_0) == u32(4294967295))
    {
        _S239 = true;
    }
    else
    {
        _S239 = is_on_horizon_0(around_6, candidate_3.edge_2);
    }
    if(_S239)
    {
        return false;
    }
    var way_2 : vec3<f64> = place_of_1(around_6, candidate_3) - around_6.position_1;
    var distance_1 : f64 = length_of_0(way_2);
    return meets_0(around_6.occluder_0, around_6.position_1, way_2 / vec3<f64>(distance_1), limit_at_0(u32(2)), distance_1 * limit_at_0(u32(3)));
}

fn list_0( candidates_1 : ptr<function, Candidates_0>,  candidate_4 : Candidate_0)
{
    var _S240 : u32 = min((*candidates_1).count_2, u32(3));
    (*candidates_1).count_2 = _S240 + u32(1);
    var place_21 : u32 = _S240;
    for(;;)
    {
        var _S241 : bool;
        if(place_21 > u32(0))
        {
            _S241 = is_before_0(candidate_4, (*candidates_1).listed_0[place_21 - u32(1)]);
        }
        else
        {
            _S241 = false;
        }
        if(_S241)
        {
        }
        else
        {
            break;
        }
        var _S242 : u32 = place_21 - u32(1);
        (*candidates_1).listed_0[place_21] = (*candidates_1).listed_0[_S242];
        place_21 = _S242;
    }
    (*candidates_1).listed_0[place_21] = candidate_4;
    return;
}

fn search_0( around_7 : Around_0,  chain_2 : Chain_0,  limit_8 : f64,  last_0 : Candidate_0) -> Candidates_0
{
    var found_4 : Candidates_0;
    found_4.count_2 = u32(0);
    var k_4 : u32 = u32(0);
    for(;;)
    {
        if(k_4 < u32(4))
        {
        }
        else
        {
            break;
        }
        found_4.listed_0[k_4] = last_0;
        k_4 = k_4 + u32(1);
    }
    var nodes_at_0 : u32 = edge_word_0(around_7.tree_0);
    var waiting_0 : array<u32, i32(92)>;
    waiting_0[i32(0)] = u32(4294967295);
    var _S243 : vec3<f32> = vec3<f32>(chain_2.image_0);
    var _S244 : vec3<f32> = vec3<f32>(chain_2.direction_11);
    var _S245 : vec2<f32> = limit_by_0(limit_8);
    var node_4 : u32 = nodes_at_0;
    var rough_limit_0 : vec2<f32> = _S245;
    var count_3 : u32 = u32(0);
    for(;;)
    {
        if(node_4 != u32(4294967295))
        {
        }
        else
        {
            break;
        }
        var next_2 : u32;
        var next_3 : u32;
        var count_4 : u32;
        var _S246 : bool;
        var skips_far_0 : bool;
        var _S247 : bool;
        if((edge_word_0(node_4)) != u32(4294967295))
        {
            var near_1 : u32 = node_4 + u32(45);
            var far_1 : u32 = nodes_at_0 + u32(45) * edge_word_0(node_4);
            var of_near_0 : Ball_0 = ball_of_0(near_1, _S243, _S244);
            var of_far_0 : Ball_0 = ball_of_0(far_1, _S243, _S244);
            var skips_near_0 : bool = is_beyond_0(of_near_0, rough_limit_0);
            var skips_far_1 : bool = is_beyond_0(of_far_0, rough_limit_0);
            if(!skips_far_1)
            {
                if(skips_near_0)
                {
                    _S246 = true;
                }
                else
                {
                    _S246 = comes_first_0(of_far_0, of_near_0);
                }
            }
            else
            {
                _S246 = false;
            }
            if(_S246)
            {
                next_2 = far_1;
                skips_far_0 = skips_near_0;
                next_3 = near_1;
            }
            else
            {
                if(!skips_near_0)
                {
                    next_2 = near_1;
                }
                else
                {
                    next_2 = u32(4294967295);
                }
                skips_far_0 = skips_far_1;
                next_3 = far_1;
            }
            if(next_2 != u32(4294967295))
            {
                _S247 = !skips_far_0;
            }
            else
            {
                _S247 = false;
            }
            if(_S247)
            {
                waiting_0[count_3] = next_3;
                count_4 = count_3 + u32(1);
            }
            else
            {
                count_4 = count_3;
            }
        }
        else
        {
            k_4 = edge_word_0(node_4 + u32(2));
            for(;;)
            {
                if(k_4 < (edge_word_0(node_4 + u32(3))))
                {
                }
                else
                {
                    break;
                }
                var candidate_5 : Candidate_0;
                var _S248 : bool = closest_on_edge_0(around_7, chain_2, chain_2.direction_11, k_4, &(candidate_5));
                if(!_S248)
                {
                    k_4 = k_4 + u32(1);
                    continue;
                }
                if(!((candidate_5.half_tangent_1) < limit_8))
                {
                    _S246 = true;
                }
                else
                {
                    _S246 = !is_before_0(last_0, candidate_5);
                }
                if(_S246)
                {
                    skips_far_0 = true;
                }
                else
                {
                    skips_far_0 = !has_room_0(found_4, candidate_5);
                }
                if(skips_far_0)
                {
                    k_4 = k_4 + u32(1);
                    continue;
                }
                if((chain_2.count_1) > u32(0))
                {
                    _S247 = true;
                }
                else
                {
                    _S247 = !is_hidden_0(around_7, candidate_5);
                }
                if(_S247)
                {
                    list_0(&(found_4), candidate_5);
                }
                k_4 = k_4 + u32(1);
            }
            var rough_limit_1 : vec2<f32>;
            if((found_4.count_2) == u32(4))
            {
                rough_limit_1 = limit_by_0(found_4.listed_0[u32(3)].half_tangent_1);
            }
            else
            {
                rough_limit_1 = rough_limit_0;
            }
            next_2 = u32(4294967295);
            rough_limit_0 = rough_limit_1;
            count_4 = count_3;
        }
        next_3 = next_2;
        count_3 = count_4;
        for(;;)
        {
            if(next_3 == u32(4294967295))
            {
                _S246 = count_3 > u32(0);
            }
            else
            {
                _S246 = false;
            }
            if(_S246)
            {
            }
            else
            {
                break;
            }
            var count_5 : u32 = count_3 - u32(1);
            if(!is_beyond_0(ball_of_0(waiting_0[count_5], _S243, _S244), rough_limit_0))
            {
                next_3 = waiting_0[count_5];
            }
            count_3 = count_5;
        }
        node_4 = next_3;
    }
    return found_4;
}

struct Nearest_0
{
     half_tangent_2 : f64,
     edge_5 : u32,
     t_8 : f64,
     direction_13 : vec3<f64>,
     distance_2 : f64,
     count_6 : u32,
     triangles_1 : array<u32, i32(6)>,
};

fn is_seen_0( around_8 : ptr<function, Around_0>,  chain_3 : Chain_0,  edge_6 : u32,  offset_4 : vec3<f64>,  point_0 : ptr<function, Nearest_0>) -> bool
{
    var _S249 : f64 = length_of_0(offset_4);
    (*point_0).distance_2 = _S249;
    (*point_0).direction_13 = offset_4 / vec3<f64>(_S249);
    (*point_0).count_6 = chain_3.count_1;
    var k_5 : u32 = chain_3.count_1;
    for(;;)
    {
        if(k_5 > u32(0))
        {
        }
        else
        {
            break;
        }
        var _S250 : u32 = k_5 - u32(1);
        (*point_0).direction_13 = mirrored_0(mirror_at_0(chain_3.triangles_0[_S250]), (*point_0).direction_13);
        k_5 = _S250;
    }
    var height_1 : f64 = abs(dot((*point_0).direction_13, (*around_8).face_0)) * (*point_0).distance_2;
    var _S251 : bool;
    if((chain_3.count_1) > u32(0))
    {
        _S251 = height_1 <= (limit_at_0(u32(2)));
    }
    else
    {
        _S251 = false;
    }
    if(_S251)
    {
        return false;
    }
    var _S252 : bool = (chain_3.count_1) == u32(0);
    if(_S252)
    {
        _S251 = is_on_horizon_0((*around_8), edge_6);
    }
    else
    {
        _S251 = false;
    }
    if(_S251)
    {
        return true;
    }
    var start_2 : vec3<f64> = (*around_8).position_1;
    var direction_14 : vec3<f64> = (*point_0).direction_13;
    k_5 = u32(0);
    var left_1 : f64 = (*point_0).distance_2;
    for(;;)
    {
        if(k_5 <= (chain_3.count_1))
        {
        }
        else
        {
            break;
        }
        var is_last_0 : bool = k_5 == (chain_3.count_1);
        var end_1 : f64;
        if(is_last_0)
        {
            end_1 = left_1 * limit_at_0(u32(3));
        }
        else
        {
            end_1 = limit_at_0(u32(1));
        }
        var unused_1 : f32;
        var found_5 : Found_0 = cast_0(start_2, direction_14, limit_at_0(u32(2)), end_1, is_last_0, &(unused_1));
        if(is_last_0)
        {
            if((found_5.face_3) == u32(4294967295))
            {
                k_5 = k_5 + u32(1);
                continue;
            }
            if(_S252)
            {
                (*around_8).occluder_0 = found_5.triangle_9;
            }
            return false;
        }
        if((found_5.face_3) == u32(4294967295))
        {
            _S251 = true;
        }
        else
        {
            _S251 = !is_mirror_0(found_5.triangle_9);
        }
        if(_S251)
        {
            return false;
        }
        var place_22 : vec3<f64> = position_of_0(place_of_0(found_5));
        var left_2 : f64 = left_1 - length_of_0(place_22 - start_2);
        if(left_2 <= 0.0lf)
        {
            return false;
        }
        var _S253 : vec3<f64> = mirrored_0(mirror_at_0(found_5.triangle_9), direction_14);
        (*point_0).triangles_1[k_5] = found_5.triangle_9;
        start_2 = place_22;
        direction_14 = _S253;
        left_1 = left_2;
        k_5 = k_5 + u32(1);
    }
    return (length_of_0(start_2 + direction_14 * vec3<f64>(left_1) - chain_3.image_0 - offset_4)) < (f64(3.99999998990097083e-06f * max(f32(chain_3.count_1), 1.0f)) * (*point_0).distance_2);
}

fn take_nearest_0( around_9 : ptr<function, Around_0>,  chain_4 : Chain_0,  best_0 : ptr<function, Nearest_0>)
{
    var last_1 : Candidate_0;
    last_1.half_tangent_1 = -1.0lf;
    last_1.t_6 = 0.0lf;
    last_1.number_1 = u32(0);
    last_1.edge_2 = u32(0);
    var is_complete_0 : bool = false;
    for(;;)
    {
        if(!is_complete_0)
        {
        }
        else
        {
            break;
        }
        var found_6 : Candidates_0 = search_0((*around_9), chain_4, (*best_0).half_tangent_2, last_1);
        var _S254 : bool = (found_6.count_2) < u32(4);
        var k_6 : u32 = u32(0);
        for(;;)
        {
            if(k_6 < (found_6.count_2))
            {
            }
            else
            {
                break;
            }
            last_1 = found_6.listed_0[k_6];
            var point_1 : Nearest_0 = (*best_0);
            var _S255 : bool = is_seen_0(&((*around_9)), chain_4, last_1.edge_2, place_of_1((*around_9), found_6.listed_0[k_6]) - chain_4.image_0, &(point_1));
            if(!_S255)
            {
                k_6 = k_6 + u32(1);
                continue;
            }
            (*best_0) = point_1;
            (*best_0).half_tangent_2 = last_1.half_tangent_1;
            (*best_0).edge_5 = last_1.edge_2;
            (*best_0).t_8 = last_1.t_6;
            return;
        }
        is_complete_0 = _S254;
    }
    return;
}

fn nearest_edge_0( around_10 : ptr<function, Around_0>,  direction_15 : vec3<f64>,  limit_9 : f64) -> Nearest_0
{
    var chain_5 : Chain_0;
    chain_5.start_0 = (*around_10).position_1;
    chain_5.image_0 = (*around_10).position_1;
    chain_5.direction_11 = direction_15;
    chain_5.facing_0 = vec3<f64>(0.0lf, 0.0lf, 0.0lf);
    chain_5.count_1 = u32(0);
    var k_7 : u32 = u32(0);
    for(;;)
    {
        if(k_7 < u32(6))
        {
        }
        else
        {
            break;
        }
        chain_5.triangles_0[k_7] = u32(0);
        k_7 = k_7 + u32(1);
    }
    var best_1 : Nearest_0;
    best_1.half_tangent_2 = limit_9;
    best_1.edge_5 = u32(4294967295);
    best_1.distance_2 = 0.0lf;
    best_1.t_8 = 0.0lf;
    best_1.direction_13 = direction_15;
    best_1.count_6 = u32(0);
    best_1.triangles_1 = chain_5.triangles_0;
    var mirrors_1 : u32 = u32(0);
    for(;;)
    {
        if(mirrors_1 <= ((*around_10).mirrors_0))
        {
        }
        else
        {
            break;
        }
        var _S256 : bool;
        if(mirrors_1 > u32(0))
        {
            var _S257 : bool = reflect_0(&(chain_5));
            _S256 = !_S257;
        }
        else
        {
            _S256 = false;
        }
        if(_S256)
        {
            break;
        }
        take_nearest_0(&((*around_10)), chain_5, &(best_1));
        mirrors_1 = mirrors_1 + u32(1);
    }
    return best_1;
}

fn tangent_by_0( direction_16 : vec3<f64>,  azimuth_0 : f32) -> vec3<f64>
{
    var axes_10 : Axes_0 = axes_around_0(vec3<f32>(direction_16), true);
    var turn_2 : vec2<f32> = sine_cosine_0(6.28318548202514648f * azimuth_0);
    var _S258 : vec3<f64> = vec3<f64>(axes_10.s_0 * vec3<f32>(turn_2.y) + axes_10.t_0 * vec3<f32>(turn_2.x));
    return exact_unit_0(_S258 - direction_16 * vec3<f64>(dot(direction_16, _S258)));
}

struct Term_0
{
     site_0 : Nearest_0,
     weight_0 : f64,
     gradient_0 : vec3<f64>,
};

struct Field_0
{
     direction_17 : vec3<f64>,
     terms_0 : array<Term_0, i32(3)>,
};

fn field_at_0( around_11 : ptr<function, Around_0>,  direction_18 : vec3<f64>,  key_5 : vec2<u32>,  first_4 : u32) -> Field_0
{
    var field_0 : Field_0;
    field_0.direction_17 = direction_18;
    var _S259 : f64 = edge_real_0(u32(4));
    const g_0 : vec3<f64> = vec3<f64>(0.0lf, 0.0lf, 0.0lf);
    var e_0 : vec3<f64> = g_0;
    var half_sine_1 : f64 = 0.0lf;
    var g_1 : vec3<f64> = g_0;
    var kappa_0 : f64 = 0.0lf;
    var is_within_0 : bool = false;
    var k_8 : u32 = u32(0);
    for(;;)
    {
        if(k_8 < u32(3))
        {
        }
        else
        {
            break;
        }
        var far_2 : f64;
        if(k_8 == u32(0))
        {
            far_2 = edge_real_0(u32(5));
        }
        else
        {
            far_2 = _S259;
        }
        var _S260 : bool = k_8 == u32(1);
        var x_10 : vec3<f64>;
        if(_S260)
        {
            x_10 = walked_1(direction_18, e_0, sqrt(f64(random_0(key_5, first_4 + u32(1)))) * half_sine_1);
        }
        else
        {
            x_10 = direction_18;
        }
        var x_11 : vec3<f64>;
        if(k_8 == u32(2))
        {
            x_11 = walked_1(direction_18, e_0, half_sine_1);
        }
        else
        {
            x_11 = x_10;
        }
        var _S261 : bool = k_8 > u32(0);
        var bound_0 : f64;
        if(_S261)
        {
            bound_0 = min(far_2, half_tangent_between_0(x_11, field_0.terms_0[i32(0)].site_0.direction_13));
        }
        else
        {
            bound_0 = far_2;
        }
        var found_7 : Nearest_0 = nearest_edge_0(&((*around_11)), x_11, bound_0);
        var _S262 : bool;
        if(_S261)
        {
            _S262 = (found_7.edge_5) == u32(4294967295);
        }
        else
        {
            _S262 = false;
        }
        var _S263 : bool;
        if(_S262)
        {
            _S263 = bound_0 < far_2;
        }
        else
        {
            _S263 = false;
        }
        var found_8 : Nearest_0;
        if(_S263)
        {
            found_8 = field_0.terms_0[i32(0)].site_0;
        }
        else
        {
            found_8 = found_7;
        }
        field_0.terms_0[k_8].site_0 = found_8;
        var _S264 : i32;
        if(_S260)
        {
            _S264 = i32(1);
        }
        else
        {
            _S264 = i32(0);
        }
        field_0.terms_0[k_8].weight_0 = f64(_S264);
        field_0.terms_0[k_8].gradient_0 = g_1;
        if(_S261)
        {
            k_8 = k_8 + u32(1);
            continue;
        }
        if((found_8.edge_5) == u32(4294967295))
        {
            field_0.terms_0[i32(2)] = field_0.terms_0[i32(0)];
            field_0.terms_0[i32(1)] = field_0.terms_0[i32(0)];
            break;
        }
        var is_within_1 : bool = (found_8.half_tangent_2) < _S259;
        var _S265 : f64 = min(found_8.half_tangent_2, _S259);
        var _S266 : f64 = 1.0lf / _S265;
        var _S267 : f64 = _S265 / sqrt(1.0lf + _S265 * _S265);
        var _S268 : vec3<f64> = tangent_by_0(direction_18, random_0(key_5, first_4));
        var towards_1 : vec3<f64> = found_8.direction_13 - direction_18 * vec3<f64>(dot(direction_18, found_8.direction_13));
        var g_2 : vec3<f64>;
        if(is_within_1)
        {
            g_2 = (vec3<f64>(0) - exact_unit_0(towards_1));
        }
        else
        {
            g_2 = g_1;
        }
        e_0 = _S268;
        half_sine_1 = _S267;
        g_1 = g_2;
        kappa_0 = _S266;
        is_within_0 = is_within_1;
        k_8 = k_8 + u32(1);
    }
    var _S269 : vec3<f64> = vec3<f64>(- kappa_0);
    field_0.terms_0[i32(0)].gradient_0 = e_0 * _S269;
    field_0.terms_0[i32(1)].gradient_0 = g_1 * _S269;
    field_0.terms_0[i32(2)].gradient_0 = (e_0 + g_1) * vec3<f64>(kappa_0);
    if(!is_within_0)
    {
        field_0.terms_0[i32(0)].site_0.edge_5 = u32(4294967295);
    }
    return field_0;
}

fn place_on_edge_0( around_12 : Around_0,  site_1 : Nearest_0) -> vec3<f64>
{
    var numbers_9 : u32 = edge_word_0(around_12.tree_0 + u32(2)) + u32(14) * site_1.edge_5;
    var start_3 : vec3<f64> = edge_position_0(numbers_9);
    return start_3 + (edge_position_0(numbers_9 + u32(3)) - start_3) * vec3<f64>(site_1.t_8);
}

struct ByCorners_0
{
     a_19 : vec3<f64>,
     b_14 : vec3<f64>,
     c_5 : vec3<f64>,
};

fn image_by_corners_0( mirror_5 : Mirror_0,  place_23 : vec3<f64>) -> ByCorners_0
{
    var across_4 : vec3<f64> = cross(mirror_5.ab_1, mirror_5.ac_1);
    var _S270 : vec3<f64> = vec3<f64>((1.0lf / dot(across_4, across_4)));
    var gradient_b_0 : vec3<f64> = cross(mirror_5.ac_1, across_4) * _S270;
    var gradient_c_0 : vec3<f64> = cross(across_4, mirror_5.ab_1) * _S270;
    var offset_5 : vec3<f64> = place_23 - mirror_5.corner_2;
    var b_15 : f64 = dot(gradient_b_0, offset_5);
    var c_6 : f64 = dot(gradient_c_0, offset_5);
    var by_1 : ByCorners_0;
    var _S271 : vec3<f64> = vec3<f64>((2.0lf * height_of_0(mirror_5, place_23)));
    by_1.a_19 = mirror_5.normal_3 * vec3<f64>((2.0lf * (1.0lf - b_15 - c_6))) + ((vec3<f64>(0) - gradient_b_0) - gradient_c_0) * _S271;
    by_1.b_14 = mirror_5.normal_3 * vec3<f64>((2.0lf * b_15)) + gradient_b_0 * _S271;
    by_1.c_5 = mirror_5.normal_3 * vec3<f64>((2.0lf * c_6)) + gradient_c_0 * _S271;
    return by_1;
}

fn angular_0( around_13 : Around_0,  site_2 : Nearest_0,  velocity_0 : vec3<f64>) -> vec3<f64>
{
    var _S272 : bool = (site_2.count_6) == u32(0);
    var is_horizon_0 : bool;
    if(_S272)
    {
        is_horizon_0 = is_on_horizon_0(around_13, site_2.edge_5);
    }
    else
    {
        is_horizon_0 = false;
    }
    var normal_4 : vec3<f64>;
    if(is_horizon_0)
    {
        normal_4 = around_13.face_0;
    }
    else
    {
        normal_4 = site_2.direction_13;
    }
    var along_5 : vec3<f64> = normal_4 * vec3<f64>(dot(normal_4, velocity_0));
    if(is_horizon_0)
    {
        return along_5 / vec3<f64>(site_2.distance_2);
    }
    var kept_0 : vec3<f64> = velocity_0 - along_5;
    var damped_0 : f64 = 1.0lf - abs(dot(around_13.face_0, site_2.direction_13)) / 0.199951171875lf;
    if(_S272)
    {
        is_horizon_0 = damped_0 > 0.0lf;
    }
    else
    {
        is_horizon_0 = false;
    }
    var kept_1 : vec3<f64>;
    if(is_horizon_0)
    {
        var numbers_10 : u32 = edge_word_0(around_13.tree_0 + u32(2)) + u32(14) * site_2.edge_5;
        var edge_7 : vec3<f64> = edge_position_0(numbers_10 + u32(3)) - edge_position_0(numbers_10);
        var seen_1 : vec3<f64> = edge_7 - site_2.direction_13 * vec3<f64>(dot(edge_7, site_2.direction_13));
        var squared_3 : f64 = dot(seen_1, seen_1);
        if(squared_3 > 0.0lf)
        {
            kept_1 = kept_0 - seen_1 * vec3<f64>((damped_0 * dot(seen_1, velocity_0) / squared_3));
        }
        else
        {
            kept_1 = kept_0;
        }
    }
    else
    {
        kept_1 = kept_0;
    }
    return kept_1 / vec3<f64>(site_2.distance_2);
}

fn velocity_of_0( around_14 : Around_0,  site_3 : Nearest_0,  velocity_of_viewpoint_0 : vec3<f32>) -> vec3<f64>
{
    var record_5 : u32 = record_of_0(around_14, site_3.edge_5) + u32(2);
    var _S273 : vec3<f64> = vec3<f64>(edge_vector_0(record_5));
    var _S274 : vec3<f64> = _S273 + (vec3<f64>(edge_vector_0(record_5 + u32(3))) - _S273) * vec3<f64>(site_3.t_8);
    var place_24 : vec3<f64> = place_on_edge_0(around_14, site_3);
    var k_9 : u32 = site_3.count_6;
    var velocity_1 : vec3<f64> = _S274;
    for(;;)
    {
        if(k_9 > u32(0))
        {
        }
        else
        {
            break;
        }
        var _S275 : u32 = k_9 - u32(1);
        var corners_0 : u32 = motion_of_0(site_3.triangles_1[_S275]);
        var mirror_6 : Mirror_0 = mirror_at_0(site_3.triangles_1[_S275]);
        var by_2 : ByCorners_0 = image_by_corners_0(mirror_6, place_24);
        var velocity_2 : vec3<f64> = mirrored_0(mirror_6, velocity_1) + by_2.a_19 * vec3<f64>(dot(mirror_6.normal_3, vec3<f64>(change_vector_0(corners_0)))) + by_2.b_14 * vec3<f64>(dot(mirror_6.normal_3, vec3<f64>(change_vector_0(corners_0 + u32(3))))) + by_2.c_5 * vec3<f64>(dot(mirror_6.normal_3, vec3<f64>(change_vector_0(corners_0 + u32(6)))));
        var _S276 : vec3<f64> = image_of_0(mirror_6, place_24);
        place_24 = _S276;
        k_9 = _S275;
        velocity_1 = velocity_2;
    }
    return angular_0(around_14, site_3, velocity_1 - vec3<f64>(velocity_of_viewpoint_0));
}

fn divergence_covector_0( field_1 : Field_0,  term_0 : Term_0) -> vec3<f64>
{
    return term_0.gradient_0 - field_1.direction_17 * vec3<f64>((2.0lf * term_0.weight_0));
}

struct Walked_0
{
     change_7 : vec3<f32>,
     divergence_1 : f32,
};

fn evaluate_0( field_2 : Field_0,  around_15 : Around_0,  velocity_of_viewpoint_1 : vec3<f32>) -> Walked_0
{
    const _S277 : vec3<f64> = vec3<f64>(0.0lf, 0.0lf, 0.0lf);
    var k_10 : u32 = u32(0);
    var change_8 : vec3<f64> = _S277;
    var divergence_2 : f64 = 0.0lf;
    for(;;)
    {
        if(k_10 < u32(3))
        {
        }
        else
        {
            break;
        }
        var _S278 : u32 = k_10;
        if((field_2.terms_0[k_10].site_0.edge_5) == u32(4294967295))
        {
            k_10 = k_10 + u32(1);
            continue;
        }
        var velocity_3 : vec3<f64> = velocity_of_0(around_15, field_2.terms_0[_S278].site_0, velocity_of_viewpoint_1);
        var divergence_3 : f64 = divergence_2 + dot(divergence_covector_0(field_2, field_2.terms_0[_S278]), velocity_3);
        change_8 = change_8 + velocity_3 * vec3<f64>(field_2.terms_0[_S278].weight_0);
        divergence_2 = divergence_3;
        k_10 = k_10 + u32(1);
    }
    var walked_2 : Walked_0;
    walked_2.change_7 = vec3<f32>(change_8 - field_2.direction_17 * vec3<f64>(dot(field_2.direction_17, change_8)));
    walked_2.divergence_1 = f32(divergence_2);
    return walked_2;
}

fn walk_onward_0( path_6 : ptr<function, Path_0>,  depth_5 : u32)
{
    var surface_6 : Surface_0 = surface_at_0((*path_6).place_1, (*path_6).direction_0.value_0);
    move_surface_0(&(surface_6), (*path_6).direction_0.value_0, (*path_6).drift_0);
    var material_1 : u32 = material_of_0(surface_6);
    var _S279 : bool;
    if(material_1 == u32(4294967295))
    {
        _S279 = true;
    }
    else
    {
        _S279 = (edge_word_0(u32(1))) == u32(4294967295);
    }
    if(_S279)
    {
        return;
    }
    var vertex_3 : Vertex_0 = vertex_at_0(surface_6, material_1, (*path_6).direction_0);
    var sample_1 : LightSample_0 = sample_material_0(vertex_3, (*path_6).key_0, first_material_number_0(depth_5));
    if(sample_1.is_specular_1)
    {
        _S279 = true;
    }
    else
    {
        _S279 = !((sample_1.wo_1.z) > 0.0f);
    }
    if(_S279)
    {
        return;
    }
    var around_16 : Around_0 = around_vertex_0(vertex_3, depth_5);
    var field_3 : Field_0 = field_at_0(&(around_16), exact_unit_0(sample_1.way_0), (*path_6).key_0, first_number_0(depth_5));
    var walked_3 : Walked_0 = evaluate_0(field_3, around_16, surface_6.position_change_0);
    (*path_6).walked_0 = walked_3.change_7;
    (*path_6).divergence_0 = walked_3.divergence_1;
    return;
}

fn set_word_0( path_7 : u32,  which_6 : u32,  value_8 : u32)
{
    paths_0[which_6 * launch_0.room_0 + path_7] = value_8;
    return;
}

fn set_vector_0( path_8 : u32,  which_7 : ptr<function, u32>,  value_9 : vec3<f32>)
{
    var axis_6 : u32 = u32(0);
    for(;;)
    {
        if(axis_6 < u32(3))
        {
        }
        else
        {
            break;
        }
        set_word_0(path_8, (*which_7) + axis_6, (bitcast<u32>((value_9[axis_6]))));
        axis_6 = axis_6 + u32(1);
    }
    (*which_7) = (*which_7) + u32(3);
    return;
}

fn loops_end_0( zero_0 : u32) -> bool
{
    var _S280 : u32;
    var rounds_0 : u32 = u32(0);
    for(;;)
    {
        var _S281 : u32 = u32(2) + zero_0;
        _S280 = _S281;
        if(rounds_0 < _S281)
        {
        }
        else
        {
            break;
        }
        rounds_0 = rounds_0 + u32(1);
    }
    return rounds_0 == _S280;
}

fn check_loops_0()
{
    if(!loops_end_0(((launch_0.room_0) >> (u32(31)))))
    {
        var _S282 : u32 = atomicAdd(&(sums_0[u32(2)]), u32(1));
    }
    return;
}

@compute
@workgroup_size(64, 1, 1)
fn walk(@builtin(global_invocation_id) thread_0 : vec3<u32>)
{
    var listed_1 : u32 = launch_0.first_0 + thread_0.x;
    if(listed_1 >= (launch_0.end_0))
    {
        return;
    }
    var number_of_path_1 : u32 = input_0[listed_1];
    var path_9 : Path_0 = load_0(number_of_path_1);
    path_9.walked_0 = vec3<f32>(0.0f);
    path_9.divergence_0 = 0.0f;
    walk_onward_0(&(path_9), launch_0.depth_0);
    var at_27 : u32 = u32(29);
    set_vector_0(number_of_path_1, &(at_27), path_9.walked_0);
    set_word_0(number_of_path_1, at_27, (bitcast<u32>((path_9.divergence_0))));
    check_loops_0();
    return;
}
