// Compiled from moved.slang by `cargo xtask kernels`. Not to be edited.
// compiler: Slang 2026.12 in slangpy 0.43.1
// source: c793651271eb566e
// result: fd5e69e0be85d01e

struct Launch_std140_0
{
    @align(16) first_0 : u32,
    @align(4) end_0 : u32,
    @align(8) capacity_0 : u32,
    @align(4) primitives_0 : u32,
};

@binding(8) @group(0) var<uniform> launch_0 : Launch_std140_0;
@binding(0) @group(0) var<storage, read> sides_0 : array<vec4<u32>>;

@binding(2) @group(0) var<storage, read> positions_0 : array<f64>;

@binding(3) @group(0) var<storage, read> faces_0 : array<vec4<u32>>;

@binding(5) @group(0) var<storage, read> others_0 : array<f64>;

@binding(7) @group(0) var<storage, read_write> primitives_1 : array<f64>;

@binding(4) @group(0) var<storage, read> tags_0 : array<vec4<u32>>;

@binding(6) @group(0) var<storage, read_write> rough_0 : array<u32>;

fn position_at_0( at_0 : u32) -> vec3<f64>
{
    return vec3<f64>(positions_0[at_0], positions_0[at_0 + u32(1)], positions_0[at_0 + u32(2)]);
}

fn position_0( vertex_0 : u32) -> vec3<f64>
{
    return position_at_0(u32(3) * vertex_0);
}

fn largest_0() -> f64
{
    return others_0[i32(4)];
}

fn rounded_0( product_0 : f64) -> f64
{
    return min(product_0, largest_0());
}

fn face_cross_0( face_0 : u32) -> vec3<f64>
{
    var corners_0 : vec4<u32> = faces_0[face_0];
    var a_0 : vec3<f64> = position_0(corners_0.x);
    var b_0 : vec3<f64> = position_0(corners_0.y) - a_0;
    var c_0 : vec3<f64> = position_0(corners_0.z) - a_0;
    var _S1 : f64 = b_0.y;
    var _S2 : f64 = c_0.z;
    var _S3 : f64 = b_0.z;
    var _S4 : f64 = c_0.y;
    var _S5 : f64 = c_0.x;
    var _S6 : f64 = b_0.x;
    return vec3<f64>(rounded_0(_S1 * _S2) - rounded_0(_S3 * _S4), rounded_0(_S3 * _S5) - rounded_0(_S6 * _S2), rounded_0(_S6 * _S4) - rounded_0(_S1 * _S5));
}

fn put_0( at_1 : u32,  v_0 : vec3<f64>)
{
    primitives_1[at_1] = v_0.x;
    primitives_1[at_1 + u32(1)] = v_0.y;
    primitives_1[at_1 + u32(2)] = v_0.z;
    return;
}

fn other_vector_0( at_2 : u32) -> vec3<f64>
{
    return vec3<f64>(others_0[at_2], others_0[at_2 + u32(1)], others_0[at_2 + u32(2)]);
}

fn inverse_scale_0() -> f64
{
    return others_0[i32(3)];
}

fn single_0( v_1 : vec3<f64>) -> vec3<f32>
{
    return vec3<f32>(f32(v_1.x), f32(v_1.y), f32(v_1.z));
}

fn put_rough_0( row_0 : u32,  edge_0 : u32,  v_2 : vec3<f32>,  word_0 : u32)
{
    var at_3 : u32 = u32(4) * (row_0 * launch_0.primitives_0 + edge_0);
    rough_0[at_3] = (bitcast<u32>((v_2.x)));
    rough_0[at_3 + u32(1)] = (bitcast<u32>((v_2.y)));
    rough_0[at_3 + u32(2)] = (bitcast<u32>((v_2.z)));
    rough_0[at_3 + u32(3)] = word_0;
    return;
}

fn least_0() -> f64
{
    return others_0[i32(5)];
}

fn unit_0( v_3 : vec3<f64>,  length_0 : f64) -> vec3<f32>
{
    var _S7 : bool;
    if(length_0 >= (least_0()))
    {
        _S7 = length_0 <= (largest_0());
    }
    else
    {
        _S7 = false;
    }
    if(!_S7)
    {
        return vec3<f32>(0.0f, 0.0f, 0.0f);
    }
    return single_0(v_3 / vec3<f64>(length_0));
}

@compute
@workgroup_size(64, 1, 1)
fn moved_edges(@builtin(global_invocation_id) thread_0 : vec3<u32>)
{
    var i_0 : u32 = launch_0.first_0 + thread_0.x;
    if(i_0 >= (launch_0.end_0))
    {
        return;
    }
    var side_0 : vec4<u32> = sides_0[i_0];
    var a_1 : vec3<f64> = position_0(side_0.x);
    var b_1 : vec3<f64> = position_0(side_0.y);
    const first_1 : vec3<f64> = vec3<f64>(0.0lf, 0.0lf, 0.0lf);
    var _S8 : u32 = side_0.z;
    var first_2 : vec3<f64>;
    var second_0 : vec3<f64>;
    if(_S8 != u32(4294967295))
    {
        var _S9 : vec3<f64> = face_cross_0(_S8);
        var _S10 : u32 = side_0.w;
        var second_1 : vec3<f64> = face_cross_0((_S10 & (u32(2147483647))));
        if(((_S10 & (u32(2147483648)))) != u32(0))
        {
            first_2 = (vec3<f64>(0) - second_1);
        }
        else
        {
            first_2 = second_1;
        }
        var _S11 : vec3<f64> = first_2;
        first_2 = _S9;
        second_0 = _S11;
    }
    else
    {
        first_2 = first_1;
        second_0 = first_1;
    }
    var first_length_0 : f64 = sqrt(dot(first_2, first_2));
    var second_length_0 : f64 = sqrt(dot(second_0, second_0));
    var _S12 : u32 = u32(14) * i_0;
    put_0(_S12, a_1);
    put_0(_S12 + u32(3), b_1);
    put_0(_S12 + u32(6), first_2);
    put_0(_S12 + u32(9), second_0);
    primitives_1[_S12 + u32(12)] = first_length_0;
    primitives_1[_S12 + u32(13)] = second_length_0;
    put_rough_0(u32(0), i_0, single_0((a_1 - other_vector_0(u32(0))) * vec3<f64>(inverse_scale_0())), tags_0[i_0].w);
    put_rough_0(u32(1), i_0, single_0((b_1 - a_1) * vec3<f64>(inverse_scale_0())), tags_0[launch_0.primitives_0 + i_0].w);
    put_rough_0(u32(2), i_0, unit_0(first_2, first_length_0), u32(0));
    put_rough_0(u32(3), i_0, unit_0(second_0, second_length_0), u32(0));
    return;
}
