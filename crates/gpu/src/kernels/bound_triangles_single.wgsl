// Compiled from bounds.slang by `cargo xtask kernels`. Not to be edited.
// compiler: Slang 2026.12 in slangpy 0.43.1
// source: be996b9947b4d3a2
// result: 3585e327604d6a58

struct Launch_std140_0
{
    @align(16) first_0 : u32,
    @align(4) end_0 : u32,
    @align(8) capacity_0 : u32,
    @align(4) primitives_0 : u32,
};

@binding(8) @group(0) var<uniform> launch_0 : Launch_std140_0;
@binding(1) @group(0) var<storage, read> below_0 : array<u32>;

@binding(2) @group(0) var<storage, read> primitives_1 : array<f32>;

@binding(6) @group(0) var<storage, read_write> words_0 : array<u32>;

@binding(0) @group(0) var<storage, read> nodes_0 : array<vec4<u32>>;

struct Four_0
{
     a_0 : vec3<f32>,
     b_0 : vec3<f32>,
     c_0 : vec3<f32>,
     d_0 : vec3<f32>,
};

fn four_0( v_0 : f32) -> Four_0
{
    var all_0 : Four_0;
    var _S1 : vec3<f32> = vec3<f32>(v_0, v_0, v_0);
    all_0.a_0 = _S1;
    all_0.b_0 = _S1;
    all_0.c_0 = _S1;
    all_0.d_0 = _S1;
    return all_0;
}

fn local_corner_0( at_0 : u32) -> vec3<f32>
{
    return vec3<f32>(primitives_1[at_0], primitives_1[at_0 + u32(1)], primitives_1[at_0 + u32(2)]);
}

var<workgroup> shared_a_0 : array<vec3<f32>, i32(64)>;

var<workgroup> shared_b_0 : array<vec3<f32>, i32(64)>;

var<workgroup> shared_c_0 : array<vec3<f32>, i32(64)>;

var<workgroup> shared_d_0 : array<vec3<f32>, i32(64)>;

fn of_all_0( own_0 : Four_0,  thread_0 : u32,  is_sum_0 : bool) -> Four_0
{
    shared_a_0[thread_0] = own_0.a_0;
    shared_b_0[thread_0] = own_0.b_0;
    shared_c_0[thread_0] = own_0.c_0;
    shared_d_0[thread_0] = own_0.d_0;
    var half_size_0 : u32 = u32(32);
    for(;;)
    {
        if(half_size_0 > u32(0))
        {
        }
        else
        {
            break;
        }
        workgroupBarrier();
        if(thread_0 < half_size_0)
        {
            var other_0 : u32 = thread_0 + half_size_0;
            var a_1 : vec3<f32> = shared_a_0[thread_0];
            var b_1 : vec3<f32> = shared_b_0[thread_0];
            var c_1 : vec3<f32> = shared_c_0[thread_0];
            var d_1 : vec3<f32> = shared_d_0[thread_0];
            var _S2 : vec3<f32>;
            if(is_sum_0)
            {
                _S2 = a_1 + shared_a_0[other_0];
            }
            else
            {
                _S2 = max(a_1, shared_a_0[other_0]);
            }
            shared_a_0[thread_0] = _S2;
            var _S3 : vec3<f32>;
            if(is_sum_0)
            {
                _S3 = b_1 + shared_b_0[other_0];
            }
            else
            {
                _S3 = max(b_1, shared_b_0[other_0]);
            }
            shared_b_0[thread_0] = _S3;
            var _S4 : vec3<f32>;
            if(is_sum_0)
            {
                _S4 = c_1 + shared_c_0[other_0];
            }
            else
            {
                _S4 = max(c_1, shared_c_0[other_0]);
            }
            shared_c_0[thread_0] = _S4;
            var _S5 : vec3<f32>;
            if(is_sum_0)
            {
                _S5 = d_1 + shared_d_0[other_0];
            }
            else
            {
                _S5 = max(d_1, shared_d_0[other_0]);
            }
            shared_d_0[thread_0] = _S5;
        }
        half_size_0 = half_size_0 / u32(2);
    }
    workgroupBarrier();
    var all_1 : Four_0;
    all_1.a_0 = shared_a_0[i32(0)];
    all_1.b_0 = shared_b_0[i32(0)];
    all_1.c_0 = shared_c_0[i32(0)];
    all_1.d_0 = shared_d_0[i32(0)];
    workgroupBarrier();
    return all_1;
}

@compute
@workgroup_size(64, 1, 1)
fn bound_triangles(@builtin(workgroup_id) group_0 : vec3<u32>, @builtin(local_invocation_index) thread_1 : u32)
{
    var k_0 : u32;
    var child_0 : u32 = launch_0.first_0 + group_0.x;
    var _S6 : u32 = u32(2) * child_0;
    var _S7 : u32 = below_0[_S6 + u32(1)];
    var box_0 : Four_0 = four_0(-3.00000000549775576e+38f);
    var i_0 : u32 = below_0[_S6] + thread_1;
    for(;;)
    {
        if(i_0 < _S7)
        {
        }
        else
        {
            break;
        }
        k_0 = u32(0);
        for(;;)
        {
            if(k_0 < u32(3))
            {
            }
            else
            {
                break;
            }
            var corner_0 : vec3<f32> = local_corner_0(u32(9) * i_0 + u32(3) * k_0);
            box_0.a_0 = max(box_0.a_0, corner_0);
            box_0.b_0 = max(box_0.b_0, (vec3<f32>(0) - corner_0));
            k_0 = k_0 + u32(1);
        }
        i_0 = i_0 + u32(64);
    }
    var _S8 : Four_0 = of_all_0(box_0, thread_1, false);
    box_0 = _S8;
    if(thread_1 != u32(0))
    {
        return;
    }
    var slot_0 : u32 = child_0 % u32(8);
    var at_1 : u32 = u32(56) * (child_0 / u32(8)) + slot_0;
    k_0 = u32(0);
    for(;;)
    {
        if(k_0 < u32(3))
        {
        }
        else
        {
            break;
        }
        var _S9 : u32 = at_1 + u32(8) * k_0;
        words_0[_S9] = (bitcast<u32>((- box_0.b_0[k_0] - 1.1920928955078125e-07f)));
        words_0[_S9 + u32(24)] = (bitcast<u32>((box_0.a_0[k_0] + 1.1920928955078125e-07f)));
        k_0 = k_0 + u32(1);
    }
    words_0[at_1 + u32(48)] = nodes_0[u32(14) * (child_0 / u32(8)) + u32(12) + slot_0 / u32(4)][slot_0 % u32(4)];
    return;
}
